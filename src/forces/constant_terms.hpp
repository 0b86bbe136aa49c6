// SPDX-License-Identifier: MIT
// Energies that are the same for all configurations.
#pragma once

#include "polhode/forces/force_field.hpp"

namespace polhode {

/// Computes the constant terms. A mesh or a polynomial that is subtracted from 1/r acts on all
/// pairs of charges, so the self-interaction of each charge and the interactions within a body are
/// subtracted. With a mesh, a uniform background neutralizes a net charge.
/// @param tail  coefficient of the dispersion correction, see dispersion_tail()
ConstantTerms constant_terms_of(const Topology& topology, const ForceSettings& settings,
                                const Box& box, double tail);
/// The coefficient of the dispersion correction; 0 if the settings have none.
double tail_of(const Topology& topology, const ForceSettings& settings);

}  // namespace polhode
