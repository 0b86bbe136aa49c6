// SPDX-License-Identifier: MIT
// Stochastic velocity rescaling [bussi2007]: a thermostat that scales all momenta by one factor.
#pragma once

#include "polhode/math/random.hpp"

namespace polhode {

/// The factor α by which momenta are scaled over a time t [bussi2007, Eq. A7]. The kinetic energy
/// relaxes to its canonical distribution with the time constant τ, exactly for any t. The factor is
/// 1 without degrees of freedom or without kinetic energy.
/// @param kinetic  kinetic energy K [kJ/mol] of n degrees of freedom
/// @param ratio    time divided by the time constant, t/τ
double rescaling_factor(double kinetic, double n, double kT, double ratio, Random random);

}  // namespace polhode
