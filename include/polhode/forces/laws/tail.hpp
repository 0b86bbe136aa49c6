// SPDX-License-Identifier: MIT
// Long-range dispersion correction.
#pragma once

#include "polhode/forces/laws/settings.hpp"
#include "polhode/model/box.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// The energy of the short-range laws that the switching function removes [kJ/mol], for a uniform
/// density of sites: Σ 2π N_a N_b/V ∫ (1 − w(r)) u(r) r² dr over ordered pairs of sites [allen2017,
/// section 2.8]. It scales as 1/V, so its virial is isotropic.
/// Meaningless for a shifted law, which changes the energy at short distances as well.
/// @throws Error  for a tabulated law, which has no values at longer distances
double dispersion_tail(const Topology& topology, const ForceSettings& settings, const Box& box);

}  // namespace polhode
