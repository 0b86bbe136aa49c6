// SPDX-License-Identifier: MIT
#include "polhode/forces/cells.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "polhode/base/error.hpp"

namespace polhode {

CellGrid::CellGrid(const Box& box, double range) : edge(box.edge) {
  const auto count = [](double edge, double width) {
    return std::clamp<std::size_t>(static_cast<std::size_t>(edge / width), 1, 1024);
  };
  cells = {count(box.edge.x, range / 4), count(box.edge.y, range / 2),
           count(box.edge.z, range / 2)};
}

std::size_t CellGrid::coordinate(double x, std::size_t d) const {
  const auto c = static_cast<std::size_t>(std::max(x, 0.0) / width(d));
  return std::min(c, cells[d] - 1);
}

Slots::Slots(const Topology& topology) {
  std::uint32_t slot = 0, bodies = 0;
  for (const auto& part : topology.parts) {
    const auto count = static_cast<std::uint32_t>(part.count);
    parts.push_back({slot, count});
    first_body_.push_back(bodies);
    bodies += count;
    slot += static_cast<std::uint32_t>((count + slot_block - 1) / slot_block * slot_block);
  }
  body.assign(slot, 0);
  cell_of_.resize(bodies);
  built_at = place = Vec3Column(slot);
}

void Slots::sort(const State& state, const CellGrid& grid) {
  cell_end.assign(parts.size() * grid.size(), 0);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    std::uint32_t* const count = &cell_end[p * grid.size()];
    const std::uint32_t first = first_body_[p], end = first + parts[p].count;
    for (std::uint32_t i = first; i < end; ++i) {
      std::size_t c[3];
      for (std::size_t d = 0; d < 3; ++d) {
        const double x = state.q[i][d];
        if (!std::isfinite(x))
          throw RunError(fmt::format("the position of molecule {} is not finite", i + 1));
        c[d] = grid.coordinate(x - std::floor(x / grid.edge[d]) * grid.edge[d], d);
      }
      cell_of_[i] = static_cast<std::uint32_t>(grid.index(c[0], c[1], c[2]));
      ++count[cell_of_[i]];
    }
    std::uint32_t slot = parts[p].first;  // counts become first slots, then ends as bodies enter
    for (std::size_t c = 0; c < grid.size(); ++c) {
      const std::uint32_t here = count[c];
      count[c] = slot;
      slot += here;
    }
    for (std::uint32_t i = first; i < end; ++i) body[count[cell_of_[i]]++] = i;
    const std::size_t whole = (parts[p].count + slot_block - 1) / slot_block * slot_block;
    for (std::size_t s = parts[p].end(); s < parts[p].first + whole; ++s) body[s] = first;
  }
  for (std::size_t s = 0; s < size(); ++s) {
    const Vec3<double> q = state.q[body[s]];
    built_at.set(s, q);
    for (std::size_t d = 0; d < 3; ++d)
      (d == 0   ? place.x
       : d == 1 ? place.y
                : place.z)[s] = q[d] - std::floor(q[d] / grid.edge[d]) * grid.edge[d];
  }
}

}  // namespace polhode
