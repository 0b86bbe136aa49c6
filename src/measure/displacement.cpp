// SPDX-License-Identifier: MIT
#include "measure/displacement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "polhode/math/fit.hpp"
#include "polhode/model/centre_of_mass.hpp"

namespace polhode {

void Displacement::follow(const State& state) {
  if (q_.size() == 0) {
    q_ = last_ = state.q;
    return;
  }
  const Vec3<double> edge = state.box.edge;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const Vec3<double> step = state.box.minimum_image(state.q[i] - last_[i]);
    q_.add(i, step);
    for (std::size_t k = 0; k < 3; ++k)
      max_step_ = std::max(max_step_, std::abs(step[k]) / edge[k]);
  }
  last_ = state.q;
}

Displacement::Displacement(const Topology& topology, std::size_t lags) : bodies_(topology) {
  for (const auto& part : topology.parts)
    parts_.emplace_back(
        part.count, lags,
        std::vector{Product::displacement_x, Product::displacement_y, Product::displacement_z});
}

void Displacement::add(const State& state, Workers& workers) {
  follow(state);
  const Vec3<double> centre = centre_of_mass(q_, bodies_);
  std::size_t first = 0;
  for (TimeCorrelation& part : parts_) {
    part.add([&](std::size_t i) { return q_[first + i] - centre; }, workers);
    first += part.bodies();
  }
}

BlockMeans Displacement::mean_square(std::size_t part, Workers& workers) {
  return parts_[part].sum_of_means(workers);
}

BlockMeans Displacement::mean_square_along(std::size_t axis, std::size_t part, Workers& workers) {
  return parts_[part].means(axis, workers);
}

namespace {

/// The lags within a window, with the mean-square displacements at these lags.
struct Points {
  std::vector<double> t, y;
};

Points within(std::span<const double> means, double interval, const FitWindow& window) {
  // The rounding of times in files changes a lag by less than this tolerance.
  const double tolerance = 0.01 * interval;
  Points points;
  for (std::size_t lag = 0; lag < means.size(); ++lag) {
    const double time = static_cast<double>(lag) * interval;
    if (time < window.from - tolerance || time > window.to + tolerance) continue;
    points.t.push_back(time);
    points.y.push_back(means[lag]);
  }
  return points;
}

double sixth_of_slope(std::span<const double> t, std::span<const double> y) {
  return t.size() < 2 ? std::numeric_limits<double>::quiet_NaN() : slope(t, y).value / 6;
}

/// The difference of D between the halves of a window, which share the lag in the middle of an odd
/// number of lags.
double rise_between_halves(const Points& points) {
  const std::span<const double> t = points.t, y = points.y;
  const std::size_t half = (t.size() + 1) / 2;
  return sixth_of_slope(t.last(half), y.last(half)) - sixth_of_slope(t.first(half), y.first(half));
}

/// The diffusion coefficient D with its error, whether or not the run is long enough.
SeriesEstimate estimate(const BlockMeans& squared, double interval, const FitWindow& window) {
  return series_estimate(squared, [&](auto means) {
    const Points points = within(means, interval, window);
    return sixth_of_slope(points.t, points.y);
  });
}

}  // namespace

SeriesEstimate diffusion(const BlockMeans& squared, double interval, const FitWindow& window) {
  const SeriesEstimate D = estimate(squared, interval, window);
  const double length = squared.sum().weight * interval;
  if (D.known == Known::yes && length < windows_of_lags * window.to)
    return {D.value, 0, Known::too_short};
  return D;
}

double fitted_displacement(const BlockMeans& squared, double interval, const FitWindow& window,
                           double lag) {
  const std::vector<double> means = squared.mean();
  const auto [t, y] = within(means, interval, window);
  return mean(y).value + slope(t, y).value * (lag - mean(t).value);
}

Convergence diffusion_convergence(const BlockMeans& squared, double interval,
                                  const FitWindow& window) {
  const SeriesEstimate D = estimate(squared, interval, window);
  const SeriesEstimate rise = series_estimate(
      squared, [&](auto means) { return rise_between_halves(within(means, interval, window)); });
  Convergence c = convergence(squared.sum().weight * interval, window.to, windows_of_lags,
                              D.known != Known::yes    ? Obstacle::no_error
                              : differs(rise, D.value) ? Obstacle::slope_changes
                                                       : Obstacle::none);
  c.min_window = 2 * interval;
  return c;
}

}  // namespace polhode
