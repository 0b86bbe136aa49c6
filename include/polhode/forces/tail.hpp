// SPDX-License-Identifier: MIT
// What a truncated Lennard-Jones law leaves out.
#pragma once

#include "polhode/forces/settings.hpp"
#include "polhode/model/box.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// The Lennard-Jones energy beyond the switch [kJ/mol] if all sites are spread uniformly there:
/// Σ 2π N_a N_b/V ∫ (1 − w(r)) u(r) r² dr over ordered pairs of sites [allen2017, section 2.8]. It
/// falls as 1/V, so that its share of the virial is as much in each direction.
///
/// @throws Error  for a shifted law, whose difference reaches into the cores
double dispersion_tail(const Topology& topology, const ForceSettings& settings, const Box& box);

}  // namespace polhode
