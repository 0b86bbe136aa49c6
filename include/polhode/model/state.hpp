// SPDX-License-Identifier: MIT
// A point in phase space, Γ = {q, p, S, ℓ} for all bodies [vanzon2008], with the box and the time.
#pragma once

#include "polhode/base/column.hpp"
#include "polhode/model/box.hpp"

namespace polhode {

struct State {
  Vec3Column q;                  ///< centres of mass [nm], lab frame, unwrapped
  Vec3Column p;                  ///< momenta [u nm/ps], lab frame
  QuaternionColumn orientation;  ///< rotation from the body frame to the lab frame; the transpose
                                 ///< of its matrix is S
  Vec3Column ell;                ///< angular momenta about the centres of mass [u nm²/ps], lab
                                 ///< frame
  Box box;          ///< periodic box [nm], which may change at any time; code that needs the box
                    ///< must read it here
  double time = 0;  ///< time of the state [ps]

  State() = default;
  State(std::size_t bodies, const Box& box)
      : q(bodies), p(bodies), orientation(bodies), ell(bodies), box(box) {}
  std::size_t size() const { return q.size(); }
};

}  // namespace polhode
