// SPDX-License-Identifier: MIT
#include "slow_modes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "math/eigen.hpp"

namespace polhode {
namespace {

struct Columns {
  std::vector<double> weights, times, values;
};

Columns columns(const BlockMeans& means, std::size_t time, std::size_t quantity) {
  Columns c;
  for (const auto& [weight, sum] : means.blocks()) {
    c.weights.push_back(weight);
    c.times.push_back(sum[time] / weight);
    c.values.push_back(sum[quantity] / weight);
  }
  return c;
}

/// The covariance of a random walk of unit rate between two block means, times the square roots of
/// the block weights. Between two blocks with centres at t and t', the covariance is min(t, t').
/// For a block with itself, the covariance is smaller than t by a sixth of the duration of the
/// block.
std::vector<double> walk_covariance(const Columns& c, double time_per_sample) {
  const std::size_t n = c.weights.size();
  std::vector<double> covariance(n * n);
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = 0; b < n; ++b) {
      const double within = a == b ? c.weights[a] * time_per_sample / 6 : 0;
      covariance[a * n + b] =
          (std::min(c.times[a], c.times[b]) - within) * std::sqrt(c.weights[a] * c.weights[b]);
    }
  return covariance;
}

/// Subtracts the components along a unit vector from the rows and columns of a matrix.
void project_out(std::vector<double>& matrix, const std::vector<double>& unit) {
  const std::size_t n = unit.size();
  const auto subtract = [&](std::size_t row, std::size_t column) {
    for (std::size_t a = 0; a < n; ++a) {
      double along = 0;
      for (std::size_t b = 0; b < n; ++b) along += unit[b] * matrix[a * row + b * column];
      for (std::size_t b = 0; b < n; ++b) matrix[a * row + b * column] -= along * unit[b];
    }
  };
  subtract(n, 1);
  subtract(1, n);
}

}  // namespace

double SlowModes::line_squared() const {
  return std::inner_product(line.begin(), line.end(), line.begin(), 0.0);
}

double SlowModes::slope() const {
  return line.empty()
             ? 0
             : std::inner_product(line.begin(), line.end(), values.begin(), 0.0) / line_squared();
}

SlowModes slow_modes(const BlockMeans& means, std::size_t time, std::size_t quantity) {
  Columns c = columns(means, time, quantity);
  const std::size_t n = c.weights.size();
  SlowModes modes;
  modes.samples = std::accumulate(c.weights.begin(), c.weights.end(), 0.0);
  const double spread = n < 2 ? 0 : c.times.back() - c.times.front();
  if (!(spread > 0)) return modes;
  modes.length = spread * static_cast<double>(n) / static_cast<double>(n - 1);
  const double first = c.times.front();
  for (double& t : c.times) t -= first;
  std::vector<double> constant;
  for (const double weight : c.weights) constant.push_back(std::sqrt(weight / modes.samples));
  std::vector<double> covariance = walk_covariance(c, modes.length / modes.samples);
  project_out(covariance, constant);
  const SymmetricEigen eigen = symmetric_eigen(covariance);
  for (std::size_t k = n - 1; k > 0; --k) {  // the smallest eigenvalue belongs to the constant
    double value = 0, line = 0;
    for (std::size_t b = 0; b < n; ++b) {
      const double weight = eigen.vectors[k][b] * std::sqrt(c.weights[b]);
      value += weight * c.values[b];
      line += weight * c.times[b];
    }
    modes.values.push_back(value);
    modes.line.push_back(line);
    modes.walk.push_back(eigen.values[k]);
  }
  return modes;
}

}  // namespace polhode
