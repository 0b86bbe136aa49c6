// SPDX-License-Identifier: MIT
#include "run/properties/dynamics.hpp"

#include <algorithm>
#include <utility>

namespace polhode {
namespace {

/// The selected sums of a segment, cut to a size.
BlockMeans::Block selected(const BlockMeans::Block& segment, const PartOfSums& part,
                           std::size_t size) {
  std::span<const double> sums = part(segment.sum);
  sums = sums.first(std::min(size, sums.size()));
  return {segment.weight, {sums.begin(), sums.end()}};
}

}  // namespace

std::vector<BlockMeans> dynamics_of(const Contributions& contributions, const PartOfSums& part) {
  std::size_t size = std::numeric_limits<std::size_t>::max();
  for (const auto& [replica, from] : contributions.all)
    for (const BlockMeans::Block& segment : replica->dynamics)
      if (const std::size_t n = part(segment.sum).size(); n > 0) size = std::min(size, n);
  std::vector<BlockMeans> runs;
  std::vector<BlockMeans::Block> all;
  std::size_t shortest = std::numeric_limits<std::size_t>::max();
  for (const auto& [replica, from] : contributions.all) {
    std::vector<BlockMeans::Block> run;
    for (const BlockMeans::Block& segment : replica->dynamics)
      if (!part(segment.sum).empty()) run.push_back(selected(segment, part, size));
    all.insert(all.end(), run.begin(), run.end());
    shortest = std::min(shortest, run.size());
    runs.emplace_back(std::move(run));
  }
  if (!runs.empty() && shortest >= min_samples) return runs;
  return {BlockMeans(std::move(all))};
}

std::vector<StepPair> pairs_of(const Contributions& contributions, const PartOfSums& part,
                               std::size_t size) {
  std::vector<StepPair> pairs;
  for (const auto& [replica, from] : contributions.all)
    for (const PairedSegment& paired : replica->paired)
      if (paired.of < replica->dynamics.size() && !part(paired.half_step.sum).empty())
        pairs.push_back({selected(replica->dynamics[paired.of], part, size),
                         selected(paired.half_step, part, size)});
  return pairs;
}

std::vector<double> overall(std::span<const BlockMeans> runs) {
  std::vector<BlockMeans::Block> sums;
  for (const BlockMeans& run : runs)
    if (!run.empty()) sums.push_back(run.sum());
  return BlockMeans(std::move(sums)).mean();
}

}  // namespace polhode
