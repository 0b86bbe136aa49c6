// SPDX-License-Identifier: MIT
// How wide the cells of a grid over a box are, so that there are not more of them than is worth it.
#pragma once

#include <algorithm>
#include <cmath>

#include "polhode/model/box.hpp"

namespace polhode {

/// `width` [nm], or as much more as it takes for whole cells of that width, one along an edge at
/// least, to be not more than `most` in all: a large box that holds little has large cells.
inline double cell_width(const Box& box, double width, double most) {
  const auto along = [&](double edge) { return std::max(1.0, std::floor(edge / width)); };
  while (along(box.edge.x) * along(box.edge.y) * along(box.edge.z) > std::max(most, 1.0))
    width *= 1.25;
  return width;
}

}  // namespace polhode
