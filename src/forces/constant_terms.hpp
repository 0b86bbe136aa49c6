// SPDX-License-Identifier: MIT
// Energies that are the same for all configurations.
#pragma once

#include "polhode/forces/force_field.hpp"

namespace polhode {

/// Computes the constant terms.
/// @param tail  coefficient of the dispersion correction, see dispersion_tail()
ConstantTerms constant_terms_of(const Topology& topology, const ForceSettings& settings,
                                const Box& box, double tail);
/// The coefficient of the dispersion correction; 0 if the settings have none.
double tail_of(const Topology& topology, const ForceSettings& settings);

}  // namespace polhode
