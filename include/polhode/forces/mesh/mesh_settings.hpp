// SPDX-License-Identifier: MIT
// Parameters of the particle mesh: the grid, the order of charge spreading, and the Coulomb split.
#pragma once

#include <array>
#include <cstddef>

namespace polhode {

struct MeshSettings {
  static constexpr int min_order = 4, max_order = 8;

  std::array<std::size_t, 3> points{16, 16, 16};  ///< grid points along each edge
  int order = 5;                                  ///< order of the B-splines
  int exponent = 6;                               ///< exponent m of the Coulomb split
  double cutoff = 1.0;                            ///< cutoff a of the Coulomb split [nm]

  friend bool operator==(const MeshSettings&, const MeshSettings&) = default;
};

}  // namespace polhode
