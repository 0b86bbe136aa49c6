// SPDX-License-Identifier: MIT
// Long-range dispersion correction.
#pragma once

#include "polhode/forces/laws/settings.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// C in the energy C/V of the short-range laws that the switching function removes, for a uniform
/// density of sites [kJ/mol nm³]: Σ 2π N_a N_b ∫ (1 − w(r)) u(r) r² dr over ordered pairs of sites
/// [allen2017, section 2.8]. The virial of C/V is isotropic.
/// Meaningless for a shifted law, which changes the energy at short distances as well.
/// @throws Error  for a tabulated law, which has no values at longer distances
double dispersion_tail(const Topology& topology, const ForceSettings& settings);

}  // namespace polhode
