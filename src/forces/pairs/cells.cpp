// SPDX-License-Identifier: MIT
#include "polhode/forces/pairs/cells.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "polhode/base/blocks.hpp"
#include "polhode/base/error.hpp"

namespace polhode {

CellGrid::CellGrid(const Box& box, double range) : edge(box.edge) {
  const auto count = [](double edge, double width) {
    return std::clamp<std::size_t>(static_cast<std::size_t>(edge / width), 1, 1024);
  };
  cells = {count(box.edge.x, range / 2), count(box.edge.y, range / 2),
           count(box.edge.z, range / 2)};
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

void Slots::sort(const State& state, const CellGrid& grid, Workers& workers) {
  constexpr std::size_t at_once = 1024;
  const auto in_box = [&](double x, std::size_t d) {
    return std::max(0.0, x - std::floor(x / grid.edge[d]) * grid.edge[d]);
  };
  each_block(state.size(), at_once, workers, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3<double> q = state.q[i];
      if (!std::isfinite(norm2(q)))
        throw RunError(fmt::format("the position of molecule {} is not finite", i + 1));
      cell_of_[i] = static_cast<std::uint32_t>(grid.index(grid.coordinate(in_box(q.x, 0), 0),
                                                          grid.coordinate(in_box(q.y, 1), 1),
                                                          grid.coordinate(in_box(q.z, 2), 2)));
    }
  });

  cell_end.assign(parts.size() * grid.size(), 0);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    std::uint32_t* const count = &cell_end[p * grid.size()];
    const std::uint32_t first = first_body_[p], end = first + parts[p].count;
    for (std::uint32_t i = first; i < end; ++i) ++count[cell_of_[i]];
    std::uint32_t slot = parts[p].first;  // counts become first slots, then end slots as bodies are
                                          // entered
    for (std::size_t c = 0; c < grid.size(); ++c) {
      const std::uint32_t here = count[c];
      count[c] = slot;
      slot += here;
    }
    for (std::uint32_t i = first; i < end; ++i) body[count[cell_of_[i]]++] = i;
    const std::size_t whole = blocks(parts[p].count, slot_block) * slot_block;
    for (std::size_t s = parts[p].end(); s < parts[p].first + whole; ++s) body[s] = first;
  }

  each_block(size(), at_once, workers, [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s) {
      const Vec3<double> q = state.q[body[s]];
      built_at.set(s, q);
      place.set(s, {in_box(q.x, 0), in_box(q.y, 1), in_box(q.z, 2)});
    }
  });
}

}  // namespace polhode
