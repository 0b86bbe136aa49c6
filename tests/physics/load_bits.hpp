// SPDX-License-Identifier: MIT
// All bits of a Load, for comparisons that allow no difference.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "polhode/model/load.hpp"

namespace polhode {

/// As whole numbers, so that a difference of signs of zero counts as well.
inline std::vector<std::uint64_t> bits(const Load& load) {
  std::vector<std::uint64_t> all;
  const auto add = [&](double x) { all.push_back(std::bit_cast<std::uint64_t>(x)); };
  for (const Vec3Column* column : {&load.f, &load.tau})
    for (std::size_t i = 0; i < column->size(); ++i)
      for (std::size_t d = 0; d < 3; ++d) add((*column)[i][d]);
  for (const double energy : {load.van_der_waals, load.coulomb, load.mesh}) add(energy);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) add(load.virial[i][k]);
  return all;
}

}  // namespace polhode
