// SPDX-License-Identifier: MIT
// The random walk of the total energy that a truncation with a discontinuous derivative drives,
// predicted from its smoothness (docs/statistics.md, "The walk of the truncation").
#pragma once

#include "polhode/forces/laws/settings.hpp"
#include "polhode/integrate/scheme.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// The mean square of the error, in units of J v^{n+1} h^{n+1}, with which the kicks of a scheme
/// integrate a force whose derivative of order n jumps by J once, at a random time: the variance of
/// Σ b_i B̃_{n+1}(c_i − θ)/(n+1)!, for kicks of weight b_i after drifts of c_i in total and periodic
/// Bernoulli polynomials B̃.
/// @param n  from 1 to 3
double passage_error(const Scheme& scheme, int n);

/// Variance per time [(kJ/mol)²/ps] of the walk of the total energy by passages of pairs through
/// the ends of the switching range, or the cutoff of a shifted law. Pairs are assumed to be
/// uniformly distributed, in orientation as well, and to move with thermal velocities. Charges
/// whose energy vanishes at the cutoff by itself (PME, damped shifted force) are left out.
/// @param volume       of the box [nm³]
/// @param temperature  [K]
/// @param step         [ps]
double truncation_walk(const Topology& topology, const ForceSettings& forces, double volume,
                       double temperature, const Scheme& scheme, double step);

}  // namespace polhode
