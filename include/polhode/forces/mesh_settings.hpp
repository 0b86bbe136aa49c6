// SPDX-License-Identifier: MIT
// What makes a particle mesh: the grid, how charges are shared among its points, the split.
#pragma once

#include <array>
#include <cstddef>

namespace polhode {

struct MeshSettings {
  static constexpr int lowest_order = 4, highest_order = 8;

  std::array<std::size_t, 3> points{16, 16, 16};  ///< of the grid along each edge
  int order = 5;                                  ///< of the B-spline
  int exponent = 6;                               ///< m of the split
  double cutoff = 1.0;                            ///< a of the split [nm]
};

}  // namespace polhode
