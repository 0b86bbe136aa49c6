// SPDX-License-Identifier: MIT
// Radial distribution functions of the dynamics, as sums that a replica stores for each segment.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "polhode/measure/radial_distribution.hpp"
#include "polhode/model/box.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// Distances between molecular centres, for each two kinds of molecules, and then between their
/// sites. The first pair is that of the first kind of molecule with itself, if there are two such
/// molecules.
class Distances {
 public:
  using Means = std::span<const double>;
  using Peak = RadialDistribution::Peak;

  /// @param bins  number of bins of each pair
  Distances(const Topology& topology, std::size_t bins);
  /// Distances up to 1.2 nm, or up to half of the shortest box edge.
  static Distances within(const Topology& topology, const Box& box);
  /// Distances for the evaluation of stored sums.
  /// @param size  size of these sums
  static Distances of_sums(const Topology& topology, std::size_t size);

  const std::vector<SitePair>& pairs() const { return pairs_; }
  std::size_t bins() const { return radial_.bins(); }
  double middle(std::size_t bin) const { return radial_.middle(bin); }

  void add(const State& state) { radial_.add(state); }
  /// The means of all frames: the volume, then counts times the volume of all pairs for each bin.
  /// Means with fewer bins are therefore the first part of means with more bins.
  std::vector<double> means() const;

  /// The factor between a mean count and g(r), for each bin of a pair.
  std::vector<double> scales(std::size_t pair) const;
  /// The index of a count in the sums.
  std::size_t index(std::size_t pair, std::size_t bin) const {
    return 1 + bin * pairs_.size() + pair;
  }
  /// The first peak of g(r) from stored sums, as in RadialDistribution.
  /// @param means     means of all sums
  /// @param estimate  makes an estimate from a function of such means
  std::optional<Peak> first_peak(std::size_t pair, Means means,
                                 const RadialDistribution::Estimate& estimate) const;

 private:
  /// Means in the order of RadialDistribution.
  std::vector<double> by_pair(Means means) const;

  std::vector<SitePair> pairs_;
  RadialDistribution radial_;
};

}  // namespace polhode
