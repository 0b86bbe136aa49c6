// SPDX-License-Identifier: MIT
// A point in phase space, Γ = {q, p, S, ℓ} for all bodies [vanzon2008], with the box and the time.
#pragma once

#include "polhode/base/column.hpp"
#include "polhode/model/box.hpp"

namespace polhode {

struct State {
  Vec3Column q;                  ///< centres of mass [nm], lab, unwrapped
  Vec3Column p;                  ///< momenta [u nm/ps], lab
  QuaternionColumn orientation;  ///< body → lab; its transposed matrix is S
  Vec3Column ell;                ///< angular momenta about the centres [u nm²/ps], lab
  Box box;          ///< [nm]; it may change at any time, so code that needs it reads it here
  double time = 0;  ///< [ps]

  State() = default;
  State(std::size_t bodies, const Box& box)
      : q(bodies), p(bodies), orientation(bodies), ell(bodies), box(box) {}
  std::size_t size() const { return q.size(); }
};

}  // namespace polhode
