// SPDX-License-Identifier: MIT
// The maximum distances between the centres of two molecules for which sites interact.
#pragma once

#include "polhode/forces/laws/settings.hpp"
#include "polhode/model/molecule.hpp"

namespace polhode {

/// Ranges of the distance between the centres of two molecules [nm].
struct CentreRanges {
  double largest = 0;  ///< range within which sites interact; 0 if they never do
  double inside = 0;   ///< range within which no interaction is truncated
};

/// Computes the ranges of two molecule types. If two sites are within the cutoff, their centres are
/// at most the cutoff plus both site-to-centre distances apart. With the molecule switch, the
/// cutoff applies to the centres.
CentreRanges centre_ranges(const ForceSettings& settings, const Molecule& a, const Molecule& b);

}  // namespace polhode
