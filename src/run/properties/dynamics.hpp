// SPDX-License-Identifier: MIT
// The dynamics of the replicas of a state point as series of blocks.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "measure/displacement.hpp"
#include "polhode/run/properties/measure.hpp"
#include "run/properties/contributions.hpp"

namespace polhode {

/// The selected sums of the segments of dynamics, with a run for each replica. While the replicas
/// are short, all segments are a single run. Sums of different sizes are cut to the smallest size.
std::vector<BlockMeans> dynamics_of(const Contributions& contributions, const PartOfSums& part);

/// All sums of a segment.
inline std::span<const double> all_sums(std::span<const double> sums) { return sums; }

/// The means over all runs.
std::vector<double> overall(std::span<const BlockMeans> runs);

using Means = std::span<const double>;
using Statistic = std::function<double(Means)>;

/// The difference of a statistic between the step and its half, with its error by the jackknife
/// over paired segments; pairs are independent, because dynamics forget their start. It is not
/// known with fewer than three pairs.
/// @param part  selects the sums, which are then cut to a size
SeriesEstimate step_difference(const Contributions& contributions, const PartOfSums& part,
                               const Statistic& statistic,
                               std::size_t size = std::numeric_limits<std::size_t>::max());
/// A bound of the time-step bias from the difference between the step and half of it.
std::optional<StepBound> step_bound(const SeriesEstimate& difference);

/// The window for fits of lines, which begins at a third of the longest lag.
FitWindow fit_window(double interval);
/// The slope of a function of the lag within a window; NaN if there are fewer than two lags.
double slope_between(Means correlation, double interval, const FitWindow& window);

/// A slope as a function of the means, from the lags in a window.
using SlopeFunction = std::function<double(Means, const FitWindow&)>;
/// Computes a slope, and checks whether it is the same in both halves of the window.
void estimate_slope(MeasuredProperty& m, std::span<const BlockMeans> runs, double interval,
                    const SlopeFunction& slope);

}  // namespace polhode
