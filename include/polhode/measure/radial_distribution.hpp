// SPDX-License-Identifier: MIT
// Radial distribution functions between sites of different molecules.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "polhode/base/workers.hpp"
#include "polhode/measure/block_means.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// Two words for sites: a site's name, or the name without digits at its end, so that "HW" are HW1
/// and HW2.
using SitePair = std::array<std::string, 2>;

/// All pairs of words, without digits, of the sites that have mass.
std::vector<SitePair> site_pairs(const Topology& topology);

struct RadialSettings {
  std::vector<SitePair> pairs;
  double reach = 1.0;  ///< [nm], not beyond half of the shortest edge
  double bin = 0.002;  ///< [nm]
};

/// Counts pairs of sites by their distance, nearest images, within one molecule left out, over
/// those of an ideal gas of molecules of the same density [allen2017, section 2.6]. Cells at least
/// as wide as the reach; counts are whole numbers, the same for any number of threads.
class RadialDistribution {
 public:
  /// @throws Error  if a word names no site
  RadialDistribution(const Topology& topology, const RadialSettings& settings);

  /// @throws Error  if the reach is more than half of an edge of the frame's box
  void add(const State& state, Workers& workers = Workers::serial());

  std::size_t bins() const { return bins_; }
  double middle(std::size_t bin) const { return (static_cast<double>(bin) + 0.5) * width_; }

  /// g(r) of the k-th pair in each bin.
  std::vector<Estimate> g(std::size_t pair) const;

  /// Sites of the second word within the end of each bin about one of the first.
  std::vector<double> coordination(std::size_t pair) const;

  struct Peak {
    Estimate place;         ///< [nm]
    Estimate height;        ///< [1]
    double minimum = 0;     ///< place of the lowest g up to 1.6 times the peak's place [nm]
    Estimate coordination;  ///< up to there
  };
  /// The first peak: the maximum of a cubic of least squares through the bins about the largest g
  /// in which g is above 0.9 of it. The minimum is looked for where shells of liquids have it: that
  /// of neighbours ends between 1.2 and 1.5 times its peak.
  Peak first_peak(std::size_t pair) const;

 private:
  struct Count {
    std::size_t histogram;
    std::uint32_t times;
  };

  double shell(std::size_t bin) const;
  std::vector<double> curve(std::size_t pair, std::span<const double> mean) const;
  std::vector<double> neighbours(std::size_t pair, std::span<const double> mean) const;

  std::vector<SitePair> pairs_;
  double reach_, width_;
  std::size_t bins_;
  std::vector<std::vector<std::pair<Vec3<double>, std::size_t>>> sites_;  // of each part: r, kind
  std::vector<std::size_t> bodies_;                                       // of each part
  std::vector<std::vector<std::vector<Count>>> counts_;                   // [kind][kind]
  std::vector<double> pairs_of_sites_, sites_of_first_;                   // of each pair
  TimeBlocks blocks_;  // of counts times the volume, for all pairs, and of the volume
};

}  // namespace polhode
