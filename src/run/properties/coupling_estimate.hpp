// SPDX-License-Identifier: MIT
// Free energies from the stages of a coupling.
#pragma once

#include "run/properties/contributions.hpp"

namespace polhode {

/// Estimates the residual chemical potential: the free energy of the last stage minus that of the
/// first one, by acceptance ratios between neighbouring stages [bennett1976]. Also estimates the
/// pressure of the vapour with the same chemical potential, with the second virial coefficient.
void estimate_coupling(MeasuredProperty& m, const Contributions& contributions,
                       const PointData& data);

/// The first segment of the coupling of a replica in equilibrium: the one from which the free
/// energy of all stages is stationary.
std::size_t coupled_from(const Replica& replica);

}  // namespace polhode
