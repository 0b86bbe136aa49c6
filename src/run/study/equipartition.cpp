// SPDX-License-Identifier: MIT
#include "run/study/equipartition.hpp"

#include <cmath>

namespace polhode {

namespace {

/// The temperature differences of a scheme at its usable steps.
struct Points {
  std::vector<double> x;  ///< powers hᵏ of the steps h
  std::vector<Estimate> y;
  double degrees_of_freedom = 0;  ///< degrees of freedom of the errors of the temperature
                                  ///< differences
};

/// The temperature differences of a curve.
/// @param excess  function that returns the temperature difference at a point
Points points_of(const Curve& curve, int order, const auto& excess) {
  Points points;
  std::vector<double> runs;
  double squares = 0;  // sum of squared deviations of single runs
  for (std::size_t i = 0; i < curve.usable; ++i) {
    const std::optional<Estimate> known = excess(curve.points[i]);
    if (!known || !(known->error > 0) || curve.points[i].runs < 2) continue;
    points.x.push_back(std::pow(curve.points[i].step, order));
    points.y.push_back(*known);
    runs.push_back(curve.points[i].runs);
    squares += (runs.back() - 1) * runs.back() * known->error * known->error;
    points.degrees_of_freedom += runs.back() - 1;
  }
  for (std::size_t i = 0; i < runs.size(); ++i)
    points.y[i].error = std::sqrt(squares / points.degrees_of_freedom / runs[i]);
  return points;
}

std::optional<Line> limit(Points points) {
  if (points.degrees_of_freedom < EquipartitionFit::min_free) return std::nullopt;
  for (bool shortened = false; points.x.size() >= (shortened ? 3 : 2); shortened = true) {
    Line line = weighted_line(points.x, points.y);
    line.degrees_of_freedom = points.degrees_of_freedom;
    if (misfit_p_value(line, points.x, points.y) >= significance) return line;
    points.x.pop_back();
    points.y.pop_back();
  }
  return std::nullopt;
}

}  // namespace

std::vector<EquipartitionFit> equipartition(const std::vector<Curve>& curves) {
  std::vector<EquipartitionFit> fits;
  for (const Curve& curve : curves) {
    EquipartitionFit fit{.scheme = curve.scheme, .axes = {}, .configurational = {}};
    if (!curve.points.empty() && curve.points[0].order > 0) fit.order = curve.points[0].order;
    for (std::size_t k = 0; k < fit.axes.size(); ++k)
      fit.axes[k] =
          limit(points_of(curve, fit.order, [k](const auto& point) { return point.excess[k]; }));
    for (std::size_t k = 0; k < fit.configurational.size(); ++k)
      fit.configurational[k] = limit(points_of(
          curve, fit.order, [k](const auto& point) { return point.configurational_excess[k]; }));
    fits.push_back(fit);
  }
  return fits;
}

}  // namespace polhode
