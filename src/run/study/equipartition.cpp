// SPDX-License-Identifier: MIT
#include "polhode/run/study/equipartition.hpp"

#include <cmath>

namespace polhode {

namespace {

/// @param excess  returns the temperature difference at a point
std::optional<Line> limit(const Curve& curve, int order, const auto& excess) {
  std::vector<double> x;
  std::vector<Estimate> y;
  for (std::size_t i = 0; i < curve.usable; ++i)
    if (const std::optional<Estimate>& known = excess(curve.points[i]); known && known->error > 0) {
      x.push_back(std::pow(curve.points[i].step, order));
      y.push_back(*known);
    }
  if (x.size() < 2) return std::nullopt;
  return weighted_line(x, y);
}

}  // namespace

std::vector<EquipartitionFit> equipartition(const std::vector<Curve>& curves) {
  std::vector<EquipartitionFit> fits;
  for (const Curve& curve : curves) {
    EquipartitionFit fit{.scheme = curve.scheme, .axes = {}, .configurational = {}};
    if (!curve.points.empty() && curve.points[0].order > 0) fit.order = curve.points[0].order;
    for (std::size_t k = 0; k < fit.axes.size(); ++k)
      fit.axes[k] = limit(curve, fit.order, [k](const auto& point) { return point.excess[k]; });
    for (std::size_t k = 0; k < fit.configurational.size(); ++k)
      fit.configurational[k] = limit(
          curve, fit.order, [k](const auto& point) { return point.configurational_excess[k]; });
    fits.push_back(fit);
  }
  return fits;
}

}  // namespace polhode
