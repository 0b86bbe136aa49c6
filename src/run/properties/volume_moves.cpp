// SPDX-License-Identifier: MIT
#include "run/properties/volume_moves.hpp"

#include <algorithm>
#include <bit>

#include "polhode/base/units.hpp"

namespace polhode {
namespace {

double relaxation_time(double step) { return std::max(2.0, 100 * step); }  // of the volume [ps]

}  // namespace

BarostatSettings barostat(const ReplicaSettings& settings, double compressibility, double step) {
  BarostatSettings b{.type = CellRescaling{relaxation_time(step)},
                     .pressure = settings.at.pressure};
  b.compressibility = compressibility;
  b.every = 25 * step;
  return b;
}

double compressibility_of_moves(const Replica& replica, const StatePoint& at) {
  constexpr double min_relaxations = 8, max_change = 16;
  const std::size_t end = std::bit_floor(replica.averages.size());
  const std::size_t later_half = end / 2;
  const double length = static_cast<double>((end - later_half) * steps_of_averages) * replica.step;
  if (end < 2 || length < min_relaxations * relaxation_time(replica.step))
    return replica.compressibility;
  double weight = 0, V = 0, V2 = 0;
  for (std::size_t k = later_half; k < end; ++k) {
    const BlockMeans::Block& sums = replica.averages[k].sums;
    weight += sums.weight;
    V += sums.sum[volume];
    V2 += sums.sum[volume_squared];
  }
  V /= weight;
  const double measured = (V2 / weight - V * V) / (units::boltzmann * at.temperature * V);
  return std::clamp(measured, replica.compressibility / max_change,
                    max_change * replica.compressibility);
}

}  // namespace polhode
