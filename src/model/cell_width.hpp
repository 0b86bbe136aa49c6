// SPDX-License-Identifier: MIT
// The width of the cells of a grid over a box, limited so that the number of cells stays useful.
#pragma once

#include <algorithm>
#include <cmath>

#include "polhode/model/box.hpp"

namespace polhode {

/// The width of cells [nm]: `width`, increased until the box has at most `max_cells` whole cells,
/// and at least one along each edge. The cells of a large, sparsely filled box are therefore large.
inline double cell_width(const Box& box, double width, double max_cells) {
  const auto along = [&](double edge) { return std::max(1.0, std::floor(edge / width)); };
  while (along(box.edge.x) * along(box.edge.y) * along(box.edge.z) > std::max(max_cells, 1.0))
    width *= 1.25;
  return width;
}

}  // namespace polhode
