// SPDX-License-Identifier: MIT
// Radial distribution functions between sites of different molecules.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "polhode/base/workers.hpp"
#include "polhode/math/fit.hpp"
#include "polhode/measure/correlated_series.hpp"
#include "polhode/measure/step_response.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// Two selections of sites: a site name, or the name without trailing digits. "HW" selects HW1 and
/// HW2. "benzene:C" selects sites of one kind of molecule, "C" sites of all kinds.
using SitePair = std::array<std::string, 2>;

/// The names of the molecules that have such sites.
std::vector<std::string> molecules_with(const Topology& topology, const std::string& selection);

/// Number of pairs of sites of different molecules.
double count_pairs(const Topology& topology, const SitePair& pair);

/// All pairs of names, without trailing digits, of sites that have mass, where different molecules
/// have them. A name that occurs in several kinds of molecules has the kind before it.
std::vector<SitePair> site_pairs(const Topology& topology);

struct RadialSettings {
  std::vector<SitePair> pairs;
  double cutoff = 1.0;  ///< cutoff [nm], at most half of the shortest edge
  double bin = 0.002;   ///< [nm]
};

/// Histogram of site-site distances by minimum image, excluding pairs within a molecule, relative
/// to an ideal gas of molecules at the same density [allen2017, section 2.6]. Cells are at least as
/// wide as the cutoff; counts are integers, the same for any number of threads.
class RadialDistribution {
 public:
  /// @throws Error  if a selection matches no site
  RadialDistribution(const Topology& topology, const RadialSettings& settings);

  /// @param error  of the step, at this state; nothing where it is not known
  /// @throws Error  if the cutoff exceeds half an edge of the frame's box
  void add(const State& state, Workers& workers = Workers::serial(),
           const std::optional<StepError>& error = {});

  std::size_t bins() const { return bins_; }
  double middle(std::size_t bin) const { return (static_cast<double>(bin) + 0.5) * width_; }

  /// g(r) of the k-th pair in each bin.
  std::vector<SeriesEstimate> g(std::size_t pair) const;

  /// Mean number of sites of the second selection around one of the first, up to the end of each
  /// bin.
  std::vector<double> coordination(std::size_t pair) const;

  struct Shell {
    SeriesEstimate end;           ///< position of the smallest g beyond the peak [nm]
    SeriesEstimate coordination;  ///< number of sites of the second selection around one of the
                                  ///< first, up to it
    SeriesEstimate of_second;     ///< number of first sites around a second site
  };
  struct Peak {
    SeriesEstimate position;     ///< [nm]
    SeriesEstimate height;       ///< [1]
    std::optional<Shell> shell;  ///< none if g still falls at the end of its range
  };
  /// The first peak, where g first exceeds 75 % of its largest value and before it falls to half of
  /// the peak. Its maximum is the maximum of a least-squares cubic through the bins in which g is
  /// above 90 % of it. A cubic through the bins around the smallest g up to 1.6 times the peak
  /// position, within 10 % of its position, gives the end of the shell. The first shell of liquids
  /// ends between 1.2 and 1.5 times the peak position. Empty if g is 0 everywhere, or largest in
  /// the last bin.
  std::optional<Peak> first_peak(std::size_t pair) const;
  /// Time-step bias of each of its numbers, to leading order.
  std::optional<Peak> first_peak_bias(std::size_t pair, double degrees_of_freedom,
                                      FixedMeans fixed) const;

 private:
  /// Makes an estimate of a number that is a function of the averages.
  using Estimate = std::function<SeriesEstimate(const StepResponse::Function&)>;
  struct Count {
    std::size_t histogram;
    std::uint32_t times;
  };

  std::optional<Peak> first_peak(std::size_t pair, const Estimate& estimate) const;
  double shell(std::size_t bin) const;
  std::vector<double> curve(std::size_t pair, std::span<const double> mean) const;
  std::vector<double> neighbours(std::size_t pair, std::span<const double> mean) const;
  double neighbours_within(std::size_t pair, double bins, std::span<const double> mean) const;

  std::vector<SitePair> pairs_;
  double cutoff_, width_;
  std::size_t bins_;
  std::vector<std::vector<std::pair<Vec3<double>, std::size_t>>> sites_;   // of each part: r, kind
  std::vector<std::size_t> bodies_;                                        // of each part
  std::vector<std::vector<std::vector<Count>>> counts_;                    // [kind][kind]
  std::vector<double> pairs_of_sites_, sites_of_first_, sites_of_second_;  // of each pair
  TimeBlocks blocks_;      // of counts times the volume, for all pairs, and of the volume
  StepResponse response_;  // of the same
};

}  // namespace polhode
