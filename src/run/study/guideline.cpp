// SPDX-License-Identifier: MIT
#include "run/study/guideline.hpp"

#include <algorithm>
#include <cmath>

#include "math/prediction.hpp"

namespace polhode {
namespace {

/// A relative error that contributes to the error of R.
ErrorPart share(double factor, const EfficiencyPoint& p) {
  return {factor * p.ratio.error / p.ratio.value, p.runs - 1.0};
}

ErrorPart relative_error(const CostAtRatio& at) {
  return {at.error / at.cost, at.degrees_of_freedom};
}

/// The number of points before the end of a curve. All tables, claims and figures use the same end
/// of a curve. A curve ends at the first step with a run that blew up. A curve ends earlier if,
/// from some step on, all longer steps have an energy drift. If a step has an energy drift but a
/// longer step has none, the drift is attributed to chance.
/// @param points  points ordered by step
std::size_t points_before_end(const std::vector<EfficiencyPoint>& points) {
  std::size_t count = 0;
  while (count < points.size() && points[count].stable) ++count;
  while (count > 0 && points[count - 1].drifts()) --count;
  return count;
}

}  // namespace

std::vector<Curve> curves(const std::vector<EfficiencyPoint>& points) {
  std::vector<Curve> all;
  for (const EfficiencyPoint& p : points) {
    auto curve =
        std::find_if(all.begin(), all.end(), [&](const Curve& c) { return c.scheme == p.scheme; });
    if (curve == all.end()) curve = all.insert(all.end(), {p.scheme, {}, 0});
    curve->points.push_back(p);
  }
  for (Curve& curve : all) {
    std::sort(curve.points.begin(), curve.points.end(),
              [](const auto& a, const auto& b) { return a.step < b.step; });
    curve.usable = points_before_end(curve.points);
  }
  return all;
}

std::optional<CostAtRatio> cost_at(const Curve& curve, double ratio) {
  if (curve.usable == 0) return std::nullopt;
  const auto& points = curve.points;
  CostAtRatio at;
  at.evaluations = points[0].cost * points[0].step;
  ErrorPart log_error;  // relative error of the step
  if (ratio < points[0].ratio.value) {
    const int order = points[0].order;
    if (order == 0 || points[0].at_rounding()) return std::nullopt;
    at.exponent = order;
    at.step = points[0].step * std::pow(ratio / points[0].ratio.value, 1.0 / order);
    at.extrapolated = true;
    log_error = share(1.0 / order, points[0]);
  }
  for (std::size_t i = 0; i + 1 < curve.usable && at.step == 0; ++i) {
    const double low = points[i].ratio.value, high = points[i + 1].ratio.value;
    if (ratio < low || ratio > high) continue;
    const double x = std::log(ratio / low) / std::log(high / low);
    at.step = points[i].step * std::pow(points[i + 1].step / points[i].step, x);
    at.exponent = std::log(high / low) / std::log(points[i + 1].step / points[i].step);
    log_error =
        summed({share((1 - x) / at.exponent, points[i]), share(x / at.exponent, points[i + 1])});
  }
  const EfficiencyPoint& last = points[curve.usable - 1];
  if (ratio > last.ratio.value) {
    at.step = last.step;
    at.at_max_step = true;
  }
  if (at.step == 0) return std::nullopt;
  at.cost = at.evaluations / at.step;
  at.error = at.cost * log_error.error;
  at.degrees_of_freedom = log_error.degrees_of_freedom;
  return at;
}

std::vector<Guideline> guidelines(const std::vector<Curve>& all,
                                  const std::vector<double>& ratios) {
  std::vector<Guideline> table;
  for (const double R : ratios) {
    Guideline line{R, {}, std::nullopt};
    for (const Curve& curve : all) {
      line.costs.push_back(cost_at(curve, R));
      const auto& cost = line.costs.back();
      if (cost && (!line.best || cost->cost < line.costs[*line.best]->cost))
        line.best = line.costs.size() - 1;
    }
    table.push_back(line);
  }
  return table;
}

std::optional<Crossing> crossover(const Curve& finer, const Curve& coarser) {
  // The logarithm of the cost ratio is computed on a fine grid of R; the crossover is the largest R
  // at which this logarithm changes sign.
  const auto advantage = [&](double R) -> std::optional<double> {
    const auto a = cost_at(finer, R), b = cost_at(coarser, R);
    for (const auto& cost : {a, b})
      if (!cost || cost->extrapolated || cost->at_max_step) return std::nullopt;
    return std::log(b->cost / a->cost);
  };
  constexpr double factor = 1.002, largest = 0.2, smallest = 1e-7;
  std::optional<double> above;
  for (double R = largest; R > smallest; R /= factor) {
    const auto here = advantage(R);
    if (here && above && *above <= 0 && *here > 0) {
      const auto a = cost_at(finer, R), b = cost_at(coarser, R);
      // The logarithm of a cost varies as −log R/exponent. The error of log R is the error of the
      // log cost ratio divided by the difference of the slopes.
      const double slopes = std::abs(1 / b->exponent - 1 / a->exponent);
      const ErrorPart error = summed({relative_error(*a), relative_error(*b)});
      return Crossing{{R, slopes > 0 ? R * error.error / slopes : 0.0}, error.degrees_of_freedom};
    }
    above = here;
  }
  return std::nullopt;
}

}  // namespace polhode
