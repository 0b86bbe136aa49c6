// SPDX-License-Identifier: MIT
// Pairs of close items in a periodic box, for computations outside the time step. Two searches for
// close pairs do not use this cell list. The neighbour list uses cells whose rows become packs
// (forces/pairs/cells). The overlap check uses hash buckets, because its range is so short that
// nearly all cells would be empty.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/counting_sort.hpp"
#include "model/wrap.hpp"

namespace polhode {

/// The width of cells [nm]: `width`, increased until the box has at most `max_cells` whole cells,
/// and at least one along each edge. The cells of a large, sparsely filled box are therefore large.
inline double cell_width(const Box& box, double width, double max_cells) {
  const auto along = [&](double edge) { return std::max(1.0, std::floor(edge / width)); };
  while (along(box.edge.x) * along(box.edge.y) * along(box.edge.z) > std::max(max_cells, 1.0))
    width *= 1.25;
  return width;
}

/// Items sorted by cells that are at least as wide as a range. Items closer than the range are in
/// the same cell or in neighbouring cells.
///
/// @tparam Item  type with a position `r` [nm], where r may be outside the box
template <class Item>
class CellList {
 public:
  /// Sorts items into cells. The number of cells is at most the number of items or 27, whichever is
  /// larger.
  CellList(const std::vector<Item>& items, const Box& box, double range) : items_(items.size()) {
    const double width = cell_width(box, range, std::max(27.0, static_cast<double>(items.size())));
    for (std::size_t d = 0; d < 3; ++d)
      cells_[d] = std::max<std::size_t>(1, static_cast<std::size_t>(box.edge[d] / width));
    ends_.resize(cells_[0] * cells_[1] * cells_[2]);
    const auto each = [&](const auto& visit) {
      for (const Item& item : items) visit(cell_of(item.r, box), item);
    };
    counting_sort(ends_, 0, each,
                  [&](std::uint32_t place, const Item& item) { items_[place] = item; });
    for (std::size_t cell = 0; cell < ends_.size(); ++cell)
      later_.push_back(later_neighbours(cell));
  }

  /// Calls visit(a, b) once for each pair in the same or in neighbouring cells.
  /// @param share, shares  number of the part of the pairs to visit, and number of all parts
  template <class Visit>
  void each_pair(const Visit& visit, std::size_t share = 0, std::size_t shares = 1) const {
    for (std::size_t cell = 0; cell < ends_.size(); ++cell)
      for (const std::size_t other : later_[cell])
        for (std::size_t a = begin_of(ends_, cell); a < ends_[cell]; ++a) {
          if (a % shares != share) continue;
          for (std::size_t b = other == cell ? a + 1 : begin_of(ends_, other); b < ends_[other];
               ++b)
            visit(items_[a], items_[b]);
        }
  }

 private:
  std::size_t cell_of(const Vec3<double>& r, const Box& box) const {
    std::size_t cell = 0;
    for (std::size_t d = 3; d-- > 0;) {
      const double c = wrapped(r[d], box.edge[d]) / box.edge[d] * static_cast<double>(cells_[d]);
      cell = cell * cells_[d] + std::min(static_cast<std::size_t>(c), cells_[d] - 1);
    }
    return cell;
  }

  // Visits the cell and its neighbours with higher numbers. Each neighbouring cell is visited once,
  // even in a small box with few cells.
  std::vector<std::size_t> later_neighbours(std::size_t cell) const {
    const std::array at = {cell % cells_[0], cell / cells_[0] % cells_[1],
                           cell / (cells_[0] * cells_[1])};
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < 27; ++k) {
      const auto along = [&](std::size_t d, std::size_t step) {
        return (at[d] + cells_[d] + step - 1) % cells_[d];
      };
      const std::size_t other =
          (along(2, k / 9) * cells_[1] + along(1, k / 3 % 3)) * cells_[0] + along(0, k % 3);
      if (other >= cell) found.push_back(other);
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  std::array<std::size_t, 3> cells_;
  std::vector<Item> items_;
  std::vector<std::uint32_t> ends_;              // one past the last item of each cell
  std::vector<std::vector<std::size_t>> later_;  // neighbours of each cell with higher numbers
};

}  // namespace polhode
