// SPDX-License-Identifier: MIT
#include "run/properties/dynamics.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "measure/convergence.hpp"
#include "measure/reorientation.hpp"
#include "polhode/math/fit.hpp"

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

CorrelationsOfDynamics::CorrelationsOfDynamics(const Topology& topology) {
  for (const auto& [molecule, molecules] : topology.parts) {
    displacement.push_back(count++);
    rotation.emplace_back();
    for (std::size_t axis = 0; axis < body_axes(molecule).size(); ++axis)
      rotation.back().push_back(count++);
  }
}

PartOfSums CorrelationsOfDynamics::functions() const {
  return [size = count * lags + pressure_bins().size()](auto sums) {
    return sums.first(std::min(size, sums.size()));
  };
}
PartOfSums CorrelationsOfDynamics::distances() const {
  return [size = count * lags + pressure_bins().size()](auto sums) {
    return sums.subspan(std::min(size, sums.size()));
  };
}

std::vector<BlockMeans> dynamics_of(const Contributions& contributions, const PartOfSums& part) {
  const auto segments_of = [&](const Contribution& c) -> const std::vector<BlockMeans::Block>& {
    return chain_of(*c.replica, contributions.what)->segments;
  };
  std::size_t size = std::numeric_limits<std::size_t>::max();
  for (const Contribution& contribution : contributions.all)
    for (const BlockMeans::Block& segment : segments_of(contribution))
      size = std::min(size, part(segment.sum).size());
  return separate_or_joined(
      runs_of(contributions, segments_of,
              [&](const BlockMeans::Block& segment) { return selected(segment, part, size); }));
}

std::vector<double> overall(std::span<const BlockMeans> runs) {
  std::vector<BlockMeans::Block> sums;
  for (const BlockMeans& run : runs)
    if (!run.empty()) sums.push_back(run.sum());
  return BlockMeans(std::move(sums)).mean();
}

FitWindow fit_window(double interval) {
  const double longest = interval * static_cast<double>(lags - 1);
  return {longest / 3, longest};
}

double slope_between(Means correlation, double interval, const FitWindow& window) {
  const double tolerance = 0.01 * interval;  // more than the rounding of lags
  std::vector<double> t, y;
  for (std::size_t k = 0; k < correlation.size(); ++k) {
    const double lag = static_cast<double>(k) * interval;
    if (lag < window.from - tolerance || lag > window.to + tolerance) continue;
    t.push_back(lag);
    y.push_back(correlation[k]);
  }
  return t.size() < 2 ? std::nan("") : slope(t, y).value;
}

SeriesEstimate step_difference(const Contributions& contributions, const PartOfSums& part,
                               const Statistic& statistic, std::size_t size) {
  constexpr std::size_t min_pairs = 3;
  std::vector<BlockMeans::Block> whole, half;
  for (const auto& [replica, from] : contributions.all) {
    const DynamicsChain& chain = *chain_of(*replica, contributions.what);
    for (const auto& [of, half_step] : chain.paired) {
      if (of >= chain.segments.size()) continue;
      whole.push_back(selected(chain.segments[of], part, size));
      half.push_back(selected(half_step, part, size));
    }
  }
  if (whole.size() < min_pairs) return {std::nan("")};
  const BlockMeans::Block all = BlockMeans(whole).sum(), all_half = BlockMeans(half).sum();
  const auto value_of = [&](const BlockMeans::Block& sum, const BlockMeans::Block& without) {
    std::vector<double> means;
    for (std::size_t k = 0; k < sum.sum.size(); ++k)
      means.push_back((sum.sum[k] - without.sum[k]) / (sum.weight - without.weight));
    return statistic(means);
  };
  std::vector<double> others;
  for (std::size_t k = 0; k < whole.size(); ++k)
    others.push_back(value_of(all, whole[k]) - value_of(all_half, half[k]));
  const double value = statistic(BlockMeans(whole).mean()) - statistic(BlockMeans(half).mean());
  const double error = jackknife_error(others);
  if (!std::isfinite(value) || !std::isfinite(error)) return {std::nan("")};
  return {value, error, Known::yes, static_cast<double>(whole.size()) - 1};
}

std::optional<StepBound> step_bound(const SeriesEstimate& difference) {
  constexpr double probability = 0.95;
  // The bias grows as the square of the step: its difference between h and h/2 is 3/4 of it.
  constexpr double of_difference = 4.0 / 3;
  if (difference.known != Known::yes) return std::nullopt;
  StepBound found{.difference = difference,
                  .pairs = static_cast<std::size_t>(difference.modes) + 1};
  found.bound = of_difference * (std::abs(difference.value) +
                                 interval_factor(difference, probability) * difference.error);
  return found;
}

void estimate_slope(MeasuredProperty& m, std::span<const BlockMeans> runs, double interval,
                    const SlopeFunction& slope) {
  const FitWindow window = fit_window(interval);
  const double middle = (window.from + window.to) / 2;
  m.value = pooled_estimate(runs, [&](Means all) { return slope(all, window); });
  const SeriesEstimate rise = pooled_estimate(runs, [&](Means all) {
    return slope(all, FitWindow{middle, window.to}) - slope(all, FitWindow{window.from, middle});
  });
  if (m.value.known == Known::yes && differs(rise, m.value.value))
    m.obstacle =
        "the slope still changes within the window of lags, because the motion is slower than "
        "this window";
}

}  // namespace polhode
