// SPDX-License-Identifier: MIT
// How many degrees of freedom carry kinetic energy: the one place that counts them.
#pragma once

#include <array>

#include "polhode/model/topology.hpp"

namespace polhode {

/// Degrees of freedom that carry kT/2 each: 3 N − 3 of translation, as the centre of mass of all
/// bodies rests (model/centre_of_mass.hpp), and one of rotation for each principal axis with
/// inertia. A single body has none of translation, a single atom none at all.
struct Freedoms {
  double translation = 0;
  std::array<double, 3> rotation{};
  double all() const { return translation + rotation[0] + rotation[1] + rotation[2]; }
};

Freedoms freedoms(const Topology& topology);

}  // namespace polhode
