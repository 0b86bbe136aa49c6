// SPDX-License-Identifier: MIT
// Long-range dispersion correction.
#pragma once

#include "polhode/forces/laws/settings.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// The coefficient C in the long-range dispersion correction C/V [kJ/mol nm³]. The correction is
/// the energy of the short-range potentials that the switching function removes, for a uniform
/// density of sites: C = Σ 2π N_a N_b ∫ (1 − w(r)) u(r) r² dr over ordered pairs of sites
/// [allen2017, section 2.8]. Its virial is isotropic. The correction is meaningless for a shifted
/// potential, because the shift also changes the energy at short distances.
/// @throws Error  for a tabulated potential, which has no values at longer distances
double dispersion_tail(const Topology& topology, const ForceSettings& settings);

}  // namespace polhode
