// SPDX-License-Identifier: MIT
#include "forces/mesh/mesh_grid.hpp"

#include "polhode/forces/mesh/mesh_settings.hpp"

namespace polhode {

template <class T>
MeshGrid<T>::MeshGrid(const std::array<std::size_t, 3>& grid_points, const MeshTile& tile_shape,
                      std::size_t overhanging_planes)
    : points(grid_points),
      tile(tile_shape),
      overhang(overhanging_planes),
      stack(odd_lines<T>((points[2] + overhang) * tile.size())),
      row(stack * stacks()),
      values(row * rows()) {
  constexpr std::size_t beyond = MeshSettings::max_order + mesh_multiple - 1;
  for (std::size_t x = 0; x < points[0] + beyond; ++x)
    stack_at.push_back(static_cast<std::ptrdiff_t>(x % points[0] / tile.columns * stack));
  for (std::size_t y = 0; y < points[1] + beyond; ++y)
    row_at.push_back(static_cast<std::ptrdiff_t>(y % points[1] / tile.rows * row));
}

template struct MeshGrid<double>;
template struct MeshGrid<float>;

}  // namespace polhode
