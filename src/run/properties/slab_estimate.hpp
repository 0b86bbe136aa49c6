// SPDX-License-Identifier: MIT
// The surface tension and the coexistence of liquid and vapour, from the slabs of the replicas.
#pragma once

#include "run/properties/contributions.hpp"

namespace polhode {

/// The first segment of the slab of a replica in equilibrium, which its potential energy shows.
std::size_t slab_from(const Replica& replica);

/// Estimates the surface tension, the densities of both phases or their pressure.
void estimate_slab(MeasuredProperty& m, const Contributions& contributions, const PointData& data);

/// Functions of the distance from the middle of the slab: the density, the normal minus the
/// tangential pressure, and its integral from the middle, which ends at the surface tension. The
/// pressures are missing for mixtures, and all of them without a slab.
std::vector<MeasuredCurve> slab_profiles(const PointData& data);

}  // namespace polhode
