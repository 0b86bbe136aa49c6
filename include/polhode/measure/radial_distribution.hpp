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

/// A pair of site selections. A selection is a site name, or the name without trailing digits: "HW"
/// selects HW1 and HW2. "benzene:C" selects sites C of benzene only, and "C" selects sites C of all
/// molecules.
using SitePair = std::array<std::string, 2>;

/// The names of the molecules that contain the selected sites.
std::vector<std::string> molecules_with(const Topology& topology, const std::string& selection);

/// The number of pairs of selected sites that are in different molecules.
double count_pairs(const Topology& topology, const SitePair& pair);

/// All pairs of site names, without trailing digits, for sites that have mass and are in different
/// molecules. If several kinds of molecules contain a site name, the name is prefixed with the
/// kind.
std::vector<SitePair> site_pairs(const Topology& topology);

struct RadialSettings {
  std::vector<SitePair> pairs;
  double cutoff = 1.0;  ///< cutoff [nm], at most half of the shortest box edge
  double bin = 0.002;   ///< bin width [nm]
};

/// Computes radial distribution functions: histograms of minimum-image site-site distances,
/// relative to an ideal gas at the same density [allen2017, section 2.6]. Pairs within a molecule
/// are excluded. Pairs are found with cells at least as wide as the cutoff. The counts of pairs are
/// integers, so they are the same for any number of threads.
class RadialDistribution {
 public:
  /// @throws Error  if a selection matches no site
  RadialDistribution(const Topology& topology, const RadialSettings& settings);

  /// Adds a frame.
  /// @param error  time-step error of this state; empty if it is not known
  /// @throws Error  if the cutoff exceeds half an edge of the frame's box
  void add(const State& state, Workers& workers = Workers::serial(),
           const std::optional<StepError>& error = {});

  std::size_t bins() const { return bins_; }
  double middle(std::size_t bin) const { return (static_cast<double>(bin) + 0.5) * width_; }

  /// The function g(r) of the k-th pair in each bin.
  std::vector<SeriesEstimate> g(std::size_t pair) const;

  /// The running coordination number: the mean number of second-selection sites around a
  /// first-selection site, up to the end of each bin.
  std::vector<double> coordination(std::size_t pair) const;

  struct Shell {
    SeriesEstimate end;           ///< position of the first minimum of g beyond the peak [nm]
    SeriesEstimate coordination;  ///< number of second-selection sites around a first-selection
                                  ///< site, within the shell
    SeriesEstimate of_second;  ///< number of first-selection sites around a second-selection site,
                               ///< within the shell
  };
  struct Peak {
    SeriesEstimate position;     ///< position of the maximum [nm]
    SeriesEstimate height;       ///< value of g at the maximum [1]
    std::optional<Shell> shell;  ///< empty if g has no minimum after the peak
  };
  /// Finds the first peak of g. The peak begins where g first exceeds 75 % of its largest value,
  /// and ends where g falls to half of the peak height. The maximum of a least-squares cubic gives
  /// position and height; the fit uses the bins in which g is above 90 % of the peak. The shell
  /// ends at the minimum of g between the peak and 1.6 times the peak position. A cubic fit to the
  /// bins within 10 % of the minimum gives the position of the minimum. The first shell of liquids
  /// ends between 1.2 and 1.5 times the peak position. The result is empty if g is 0 everywhere, or
  /// largest in the last bin.
  std::optional<Peak> first_peak(std::size_t pair) const;
  /// Estimates a number that is a function of the averages in means().
  using Estimate = std::function<SeriesEstimate(const StepResponse::Function&)>;
  /// The first peak from averages that were stored elsewhere.
  /// @param mean      averages in the order of means(), which determine the bins of the fits
  /// @param estimate  makes each number of the peak
  std::optional<Peak> first_peak(std::size_t pair, std::span<const double> mean,
                                 const Estimate& estimate) const;
  /// Averages over all frames: count times volume for each pair and bin, and finally the volume.
  std::vector<double> means() const { return blocks_.means().mean(); }
  /// The function g(r) of the k-th pair in each bin, from averages in the order of means().
  std::vector<double> g(std::size_t pair, std::span<const double> mean) const;
  /// The time-step bias of each number of first_peak(), to leading order.
  std::optional<Peak> first_peak_bias(std::size_t pair, double degrees_of_freedom,
                                      FixedMeans fixed) const;

 private:
  struct Count {
    std::size_t histogram;
    std::uint32_t times;
  };

  double shell(std::size_t bin) const;
  std::vector<double> neighbours(std::size_t pair, std::span<const double> mean) const;
  double neighbours_within(std::size_t pair, double bins, std::span<const double> mean) const;

  std::vector<SitePair> pairs_;
  double cutoff_, width_;
  std::size_t bins_;
  std::vector<std::vector<std::pair<Vec3<double>, std::size_t>>>
      sites_;                                            // body-frame position and kind of the
                                                         // sites of each part
  std::vector<std::size_t> bodies_;                      // number of bodies of each part
  std::vector<std::vector<std::vector<Count>>> counts_;  // counters by [kind][kind]
  std::vector<double> pairs_of_sites_, sites_of_first_,
      sites_of_second_;    // numbers of sites of each pair
  TimeBlocks blocks_;      // counts times the volume for all pairs, and the volume
  StepResponse response_;  // time-step response of the same quantities
};

}  // namespace polhode
