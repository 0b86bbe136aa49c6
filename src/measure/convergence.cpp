// SPDX-License-Identifier: MIT
#include "measure/convergence.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "polhode/base/vec3.hpp"

namespace polhode {
namespace {

/// The mean of the blocks from `first` to `end`.
std::vector<double> mean_of(const BlockMeans& blocks, std::size_t first, std::size_t end) {
  const auto begin = blocks.blocks().begin();
  return BlockMeans(
             {begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(end)})
      .mean();
}

}  // namespace

double relaxation_share(const BlockMeans& blocks, std::size_t x, std::size_t square) {
  const std::size_t count = blocks.blocks().size();
  if (count == 0) return 0;
  const double mean_square = blocks.mean()[square];
  double sum = 0, scales = 0;
  for (std::size_t parts = 1; parts <= std::min<std::size_t>(4, count); parts *= 2) {
    double squares = 0;
    for (std::size_t k = 0; k < parts; ++k) {
      const auto mean = mean_of(blocks, k * count / parts, (k + 1) * count / parts);
      squares += norm2(Vec3<double>{mean[x], mean[x + 1], mean[x + 2]});
    }
    const auto n = static_cast<double>(parts);
    sum += squares / n / mean_square / 2 / n;
    ++scales;
  }
  return sum / scales;
}

Convergence convergence(double length, double relaxation, double multiple, Obstacle other) {
  const double needed = multiple * relaxation;
  if (length < needed) return {length, relaxation, needed, "ps", Obstacle::length};
  return {length, relaxation, other == Obstacle::none ? needed : 2 * length, "ps", other};
}

bool still_moving(const BlockMeans& blocks, const SeriesEstimate& whole,
                  const std::function<double(std::span<const double>)>& statistic) {
  if (whole.known != Known::yes) return false;
  const double first = statistic(mean_of(blocks, 0, blocks.blocks().size() / 2));
  return !(std::abs(first - whole.value) <= three_sigma(whole));
}

bool differs(const SeriesEstimate& difference, double value) {
  constexpr double matters = 0.1;
  return difference.known == Known::yes && std::abs(difference.value) > three_sigma(difference) &&
         std::abs(difference.value) > matters * std::abs(value);
}

bool matters(const SeriesEstimate& systematic, const SeriesEstimate& result) {
  const double size = std::abs(systematic.value);
  return systematic.known == Known::yes && size > three_sigma(systematic) && size > result.error;
}

}  // namespace polhode
