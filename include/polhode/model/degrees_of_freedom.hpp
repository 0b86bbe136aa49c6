// SPDX-License-Identifier: MIT
// The number of degrees of freedom that have kinetic energy. All other code uses the functions in
// this file.
#pragma once

#include <array>

#include "polhode/model/topology.hpp"

namespace polhode {

/// Whether the total momentum of a system is held at 0, or is free, as it is in an external field.
enum class TotalMomentum { held, free };

/// Numbers of degrees of freedom. The mean kinetic energy per degree of freedom is kT/2.
/// Translation has 3 N degrees of freedom, or 3 N − 3 if the centre of mass of all bodies is at
/// rest (model/centre_of_mass.hpp). The centre of mass is at rest in all runs. Rotation has one
/// degree of freedom for each principal axis with a nonzero moment of inertia. A single body at
/// rest has no translational degrees of freedom, and a single atom has none at all.
struct DegreesOfFreedom {
  double translation = 0;
  std::array<double, 3> rotation{};
  double all() const { return translation + rotation[0] + rotation[1] + rotation[2]; }
};

DegreesOfFreedom degrees_of_freedom(const Topology& topology,
                                    TotalMomentum total_momentum = TotalMomentum::held);

}  // namespace polhode
