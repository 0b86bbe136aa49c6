// SPDX-License-Identifier: MIT
// The distances of the centres of two molecules within which their sites interact.
#pragma once

#include <algorithm>

#include "polhode/forces/laws/settings.hpp"
#include "polhode/model/molecule.hpp"

namespace polhode {

/// Distances of the centres of two molecules [nm].
struct CentreRanges {
  double charges = 0, short_range = 0;  ///< within which these interact; 0 if they never do
  double inside = 0;                    ///< within which nothing is truncated

  double largest() const { return std::max(charges, short_range); }
};

/// Two sites within a cutoff have centres at most that cutoff plus their own distances from these
/// centres apart; with the molecule switch, the cutoff is that of the centres.
CentreRanges centre_ranges(const ForceSettings& settings, const Molecule& a, const Molecule& b);

}  // namespace polhode
