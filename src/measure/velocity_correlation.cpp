// SPDX-License-Identifier: MIT
#include "measure/velocity_correlation.hpp"

#include <cmath>
#include <utility>

#include "polhode/base/units.hpp"
#include "polhode/model/centre_of_mass.hpp"

namespace polhode {
namespace {

BlockMeans divided(const BlockMeans& means, double by) {
  std::vector<BlockMeans::Block> blocks = means.blocks();
  for (BlockMeans::Block& block : blocks)
    for (double& sum : block.sum) sum /= by;
  return BlockMeans(std::move(blocks));
}

/// The integral by the trapezoidal rule over every `stride`-th lag, up to a given lag.
double trapezia(std::span<const double> C, double interval, std::size_t stride, std::size_t last) {
  double sum = (C.front() + C[last]) / 2;
  for (std::size_t lag = stride; lag < last; lag += stride) sum += C[lag];
  return sum * static_cast<double>(stride) * interval;
}

}  // namespace

VelocityCorrelation::VelocityCorrelation(const Topology& topology, std::size_t lags)
    : bodies_(topology) {
  for (const auto& [molecule, count] : topology.parts) {
    molecules_.push_back(molecule);
    linear_.emplace_back(count, lags, std::vector{Product::dot});
    angular_.emplace_back(count, lags, std::vector{Product::x, Product::y, Product::z});
  }
}

void VelocityCorrelation::add(const State& state, Workers& workers) {
  const Vec3<double> common = 1 / total_mass(bodies_) * total_momentum(state);
  std::size_t first = 0;
  for (std::size_t part = 0; part < linear_.size(); ++part) {
    linear_[part].add(
        [&](std::size_t i) { return bodies_.inverse_m[first + i] * state.p[first + i] - common; },
        workers);
    if (!turning_axes(part).empty())
      angular_[part].add(
          [&](std::size_t i) {
            const Quaternion<double>& S = state.orientation[first + i];
            const Vec3<double> w =
                scaled(bodies_.inverse_J[first + i], to_body(S, state.ell[first + i]));
            return linear_body(part) ? to_lab(S, w) : w;
          },
          workers);
    first += linear_[part].bodies();
  }
}

BlockMeans VelocityCorrelation::linear(std::size_t part, Workers& workers) {
  return divided(linear_[part].means(0, workers), 3);
}

BlockMeans VelocityCorrelation::angular(std::size_t part, std::size_t axis, Workers& workers) {
  return linear_body(part) ? divided(angular_[part].sum_of_means(workers), 2)
                           : angular_[part].means(axis, workers);
}

bool VelocityCorrelation::linear_body(std::size_t part) const {
  return molecules_[part].top == Top::linear;
}

std::vector<std::size_t> VelocityCorrelation::turning_axes(std::size_t part) const {
  std::vector<std::size_t> axes;
  for (std::size_t k = 0; k < 3; ++k)
    if (molecules_[part].J[k] > 0) axes.push_back(k);
  if (linear_body(part)) axes.resize(1);
  return axes;
}

BlockMeans running_integral(const BlockMeans& correlation, double interval) {
  std::vector<BlockMeans::Block> blocks = correlation.blocks();
  for (BlockMeans::Block& block : blocks) {
    double integral = 0, before = block.sum.front();
    block.sum.front() = 0;
    for (std::size_t lag = 1; lag < block.sum.size(); ++lag) {
      integral += (before + block.sum[lag]) / 2 * interval;
      before = std::exchange(block.sum[lag], integral);
    }
  }
  return BlockMeans(std::move(blocks));
}

Convergence integral_convergence(const BlockMeans& correlation, double interval) {
  const BlockMeans integral = running_integral(correlation, interval);
  const std::size_t last = integral.mean().size() - 1, even = last - last % 2;
  const SeriesEstimate whole = series_estimate(integral, [&](auto means) { return means[last]; });
  const SeriesEstimate rise =
      series_estimate(integral, [&](auto means) { return means[last] - means[last / 2]; });
  const SeriesEstimate rule = series_estimate(correlation, [&](auto C) {
    return (trapezia(C, interval, 2, even) - trapezia(C, interval, 1, even)) / 3;
  });
  Convergence c = convergence(integral.sum().weight * interval,
                              static_cast<double>(last) * interval, windows_of_lags,
                              whole.known != Known::yes    ? Obstacle::no_error
                              : matters(rule, whole)       ? Obstacle::interval
                              : differs(rise, whole.value) ? Obstacle::integral_changes
                                                           : Obstacle::none);
  c.interval = interval / 2;
  c.min_window = 2 * interval;
  return c;
}

// To first order, each block of the normalized function deviates from the mean by the contribution
// of that block.
BlockMeans normalized(const BlockMeans& correlation) {
  const std::vector<double> C = correlation.mean();
  if (C.empty() || C.front() == 0) return correlation;
  std::vector<BlockMeans::Block> blocks = correlation.blocks();
  for (BlockMeans::Block& block : blocks) {
    const double effective = block.sum.front() / C.front();
    for (std::size_t lag = 0; lag < C.size(); ++lag)
      block.sum[lag] = (block.sum[lag] + (block.weight - effective) * C[lag]) / C.front();
  }
  return BlockMeans(std::move(blocks));
}

Spectrum spectrum(const BlockMeans& correlation, double interval) {
  const std::vector<double> C = correlation.mean();
  if (C.size() < 2) return {};
  const double length = static_cast<double>(C.size() - 1) * interval;
  std::vector<BlockMeans::Block> blocks = normalized(correlation).blocks();
  for (BlockMeans::Block& block : blocks) {
    for (std::size_t lag = 0; lag < C.size(); ++lag) {
      const double half_angle = units::pi / 2 * static_cast<double>(lag) * interval / length;
      block.sum[lag] *= 4 * std::cos(half_angle) * std::cos(half_angle);
    }
    block.sum = cosine_transform(block.sum, interval);
  }
  Spectrum result;
  for (std::size_t k = 0; k < C.size(); ++k)
    result.frequency.push_back(static_cast<double>(k) / (2 * length));
  result.intensity = series_estimates(BlockMeans(std::move(blocks)));
  return result;
}

}  // namespace polhode
