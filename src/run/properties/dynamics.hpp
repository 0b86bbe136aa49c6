// SPDX-License-Identifier: MIT
// The dynamics of the replicas of a state point as series of blocks.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "run/properties/contributions.hpp"

namespace polhode {

/// Dynamics with the selected sums, as a run for each replica. While the replicas are short, all
/// segments are a single run. Segments without these sums are left out. Sums of different sizes are
/// cut to the smallest size.
std::vector<BlockMeans> dynamics_of(const Contributions& contributions, const PartOfSums& part);

/// A segment of dynamics, and the same at half of the step.
struct StepPair {
  BlockMeans::Block whole, half;
};
/// The paired segments with the selected sums, which are cut to a size.
std::vector<StepPair> pairs_of(const Contributions& contributions, const PartOfSums& part,
                               std::size_t size = std::numeric_limits<std::size_t>::max());

/// The means over all runs.
std::vector<double> overall(std::span<const BlockMeans> runs);

}  // namespace polhode
