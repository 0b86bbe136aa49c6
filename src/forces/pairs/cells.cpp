// SPDX-License-Identifier: MIT
#include "forces/pairs/cells.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/blocks.hpp"
#include "base/counting_sort.hpp"
#include "model/wrap.hpp"
#include "polhode/base/error.hpp"

namespace polhode {

CellGrid::CellGrid(const Box& box, std::size_t bodies) : edge(box.edge) {
  const double width =
      std::cbrt(block * box.volume() / static_cast<double>(std::max<std::size_t>(1, bodies)));
  const auto count = [](double pieces) {
    return std::max<std::size_t>(1, static_cast<std::size_t>(std::round(pieces)));
  };
  cells = {count(edge.x / width), count(edge.y / width), count(slices * edge.z / width)};
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

void Slots::sort(const State& state, Workers& workers) {
  const Box& box = state.box;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const CellGrid grid(box, parts[p].count);
    const std::uint32_t first = first_body_[p], end = first + parts[p].count;
    each_block(parts[p].count, slots_at_once, workers, [&](std::size_t from, std::size_t to) {
      for (std::size_t i = first + from; i < first + to; ++i) {
        const Vec3<double> q = state.q[i];
        if (!std::isfinite(norm2(q)))
          throw RunError(fmt::format("the position of molecule {} is not finite", i + 1));
        const Vec3<double> r = wrapped(q, box);
        cell_of_[i] = static_cast<std::uint32_t>(
            grid.index(grid.coordinate(r.x, 0), grid.coordinate(r.y, 1), grid.coordinate(r.z, 2)));
      }
    });
    cell_end_.resize(grid.size());
    const auto each = [&](const auto& visit) {
      for (std::uint32_t i = first; i < end; ++i) visit(cell_of_[i], i);
    };
    counting_sort(cell_end_, parts[p].first, each,
                  [&](std::uint32_t slot, std::uint32_t i) { body[slot] = i; });
    const std::size_t whole = blocks(parts[p].count, slot_block) * slot_block;
    for (std::size_t s = parts[p].end(); s < parts[p].first + whole; ++s) body[s] = first;
  }

  each_block(size(), slots_at_once, workers, [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s) {
      const Vec3<double> q = state.q[body[s]];
      built_at.set(s, q);
      place.set(s, wrapped(q, box));
    }
  });
}

}  // namespace polhode
