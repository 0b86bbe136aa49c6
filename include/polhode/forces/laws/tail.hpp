// SPDX-License-Identifier: MIT
// Long-range dispersion correction.
#pragma once

#include "polhode/forces/laws/settings.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// C in the energy C/V of the short-range laws beyond the switch, for a uniform density of sites
/// there [kJ/mol nm³]: Σ 2π N_a N_b ∫ (1 − w(r)) u(r) r² dr over ordered pairs of sites [allen2017,
/// section 2.8]. The virial of C/V is isotropic.
/// Meaningless for a shifted law, which changes the energy at short distances as well.
/// @throws Error  for a tabulated law, which ends
double dispersion_tail(const Topology& topology, const ForceSettings& settings);

}  // namespace polhode
