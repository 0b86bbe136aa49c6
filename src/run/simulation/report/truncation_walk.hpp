// SPDX-License-Identifier: MIT
// The random walk of the total energy due to a truncation with a discontinuous derivative. The
// random walk is predicted from the smoothness of the truncation (docs/statistics.md, "The walk of
// the truncation").
#pragma once

#include "polhode/forces/laws/settings.hpp"
#include "polhode/integrate/scheme.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// The mean square error of an integrated force, in units of J v^{n+1} h^{n+1}. The n-th derivative
/// of the force has a jump J at a random time. For the kicks of a scheme, the mean square error is
/// the variance of Σ b_i B̃_{n+1}(c_i − θ)/(n+1)!. Kick i has the weight b_i and follows drifts of
/// total length c_i, and B̃ are periodic Bernoulli polynomials.
/// @param n  order of the derivative, from 1 to 3
double passage_error(const Scheme& scheme, int n);

/// Variance per time [(kJ/mol)²/ps] of the random walk of the total energy that truncation causes.
/// The energy changes when pairs pass the ends of the switching range, or the cutoff of a shifted
/// potential. Pairs are assumed to have uniformly distributed positions and orientations, and
/// thermal velocities. Charges are not included if their energy vanishes at the cutoff without
/// truncation (PME, damped shifted force).
/// @param volume       volume of the box [nm³]
/// @param temperature  temperature [K]
/// @param step         time step [ps]
double truncation_walk(const Topology& topology, const ForceSettings& forces, double volume,
                       double temperature, const Scheme& scheme, double step);

}  // namespace polhode
