// SPDX-License-Identifier: MIT
#include "measure/reorientation.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "model/dipole.hpp"

namespace polhode {
namespace {

// The slope of the line through (t, ln C) with weights C².
double decay_rate(std::span<const double> C, double interval, std::size_t first, std::size_t last) {
  double w = 0, wt = 0, wy = 0, wtt = 0, wty = 0;
  for (std::size_t lag = first; lag <= last; ++lag) {
    if (C[lag] <= 0) continue;
    const double t = static_cast<double>(lag) * interval, y = std::log(C[lag]);
    const double weight = C[lag] * C[lag];
    w += weight, wt += weight * t, wy += weight * y, wtt += weight * t * t, wty += weight * t * y;
  }
  return -(w * wty - wt * wy) / (w * wtt - wt * wt);
}

double trapezia(std::span<const double> C, double interval, std::size_t last) {
  double sum = 0;
  for (std::size_t lag = 0; lag < last; ++lag) sum += (C[lag] + C[lag + 1]) / 2;
  return sum * interval;
}

}  // namespace

std::vector<BodyAxis> body_axes(const Molecule& molecule) {
  if (molecule.top == Top::atom) return {};
  if (molecule.top == Top::linear)
    return {{"axis 1", {1, 0, 0}}};  // J1 = 0, so axis 1 is along the molecule
  std::vector<BodyAxis> axes = {
      {"axis 1", {1, 0, 0}}, {"axis 2", {0, 1, 0}}, {"axis 3", {0, 0, 1}}};
  if (has_dipole(molecule)) axes.push_back({"dipole", dipole_moment(molecule) / molecule.dipole()});
  return axes;
}

Reorientation::Reorientation(const Topology& topology, std::size_t lags) {
  std::size_t first = 0;
  for (const auto& [molecule, count] : topology.parts) {
    Part part{first, count, body_axes(molecule), {}};
    for (std::size_t k = 0; k < part.axes.size(); ++k)
      part.correlations.emplace_back(count, lags, std::vector{Product::dot, Product::dot_squared});
    parts_.push_back(std::move(part));
    first += count;
  }
}

void Reorientation::add(const State& state, Workers& workers) {
  for (Part& part : parts_)
    for (std::size_t k = 0; k < part.axes.size(); ++k)
      part.correlations[k].add(
          [&](std::size_t i) {
            return to_lab(state.orientation[part.first + i], part.axes[k].direction);
          },
          workers);
}

BlockMeans Reorientation::legendre(std::size_t part, std::size_t axis, int rank, Workers& workers) {
  TimeCorrelation& correlation = parts_[part].correlations[axis];
  if (rank == 1) return correlation.means(0, workers);
  std::vector<BlockMeans::Block> blocks = correlation.means(1, workers).blocks();
  for (BlockMeans::Block& block : blocks)
    for (double& sum : block.sum) sum = (3 * sum - block.weight) / 2;
  return BlockMeans(std::move(blocks));
}

std::optional<RelaxationTimes> relaxation_times(const BlockMeans& correlation, double interval) {
  const std::vector<double> C = correlation.mean();
  const auto below = [&](double level) {
    return static_cast<std::size_t>(std::ranges::find_if(C, [&](double c) { return c < level; }) -
                                    C.begin());
  };
  const std::size_t first = below(std::exp(-1.0)), last = below(std::exp(-3.0));
  if (last >= C.size() || last < first + 2) return std::nullopt;
  RelaxationTimes times;
  times.from = static_cast<double>(first) * interval;
  times.to = static_cast<double>(last) * interval;
  times.exponential = series_estimate(correlation, [&](std::span<const double> c) {
    return 1 / decay_rate(c, interval, first, last);
  });
  times.integral = series_estimate(correlation, [&](std::span<const double> c) {
    return trapezia(c, interval, last) + c[last] / decay_rate(c, interval, first, last);
  });
  times.convergence =
      convergence(correlation.sum().weight * interval, times.to, windows_of_lags,
                  times.exponential.known == Known::yes && times.integral.known == Known::yes
                      ? Obstacle::none
                      : Obstacle::no_error);
  return times;
}

}  // namespace polhode
