// SPDX-License-Identifier: MIT
#include "run/properties/volume_moves.hpp"

#include <algorithm>
#include <bit>

#include "polhode/base/units.hpp"
#include "run/prepare/compressibility.hpp"

namespace polhode {

BarostatSettings barostat(const ReplicaSettings& settings, double compressibility, double step) {
  BarostatSettings b{.type = CellRescaling{std::max(2.0, 100 * step)},
                     .pressure = settings.at.pressure};
  b.compressibility = compressibility;
  b.every = 25 * step;
  return b;
}

double compressibility_of_moves(const Replica& replica, const StatePoint& at) {
  constexpr std::size_t first = 2;
  const std::size_t end = std::bit_floor(replica.averages.size());
  if (end < first) return replica.compressibility;
  double weight = 0, V = 0, V2 = 0;
  for (std::size_t k = end / 2; k < end; ++k) {
    const BlockMeans::Block& sums = replica.averages[k].sums;
    weight += sums.weight;
    V += sums.sum[volume];
    V2 += sums.sum[volume_squared];
  }
  V /= weight;
  const double measured = (V2 / weight - V * V) / (units::boltzmann * at.temperature * V);
  return within_materials(measured);
}

}  // namespace polhode
