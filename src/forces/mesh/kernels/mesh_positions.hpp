// SPDX-License-Identifier: MIT
// Positions of charged sites on the grid, for a pack of bodies.
#pragma once

#include <array>

#include "base/pack_grid.hpp"
#include "forces/mesh/mesh_loops.hpp"

namespace polhode::POLHODE_LOOPS {
namespace {

// Loads the records of consecutive slots, transposed into packs.
template <class T>
class GridPositions {
 public:
  using Real = Pack<T>;

  GridPositions(const Box& box, const std::array<std::size_t, 3>& points, std::size_t sites)
      : box_(box), points_(points), numbers_(3 + 3 * sites) {}

  void load(const SiteRecords<T>& records, std::size_t slot) {
    for (std::size_t k = 0; k < numbers_; k += Real::width)
      transpose<T>([&](std::size_t lane) { return Real::load(records.of(slot + lane) + k); },
                   column_.data() + k);
  }
  Vec3<Real> centre() const { return {column_[0], column_[1], column_[2]}; }
  Vec3<Real> arm(std::size_t site) const {
    return {column_[3 + 3 * site], column_[4 + 3 * site], column_[5 + 3 * site]};
  }
  // Loads a site's displacement, in grid spacings, from the displacement records.
  Vec3<Real> in_spacings(std::size_t site) const {
    Vec3<Real> move = centre() + arm(site);
    for (std::size_t d = 0; d < 3; ++d)
      move[d] *= Real(static_cast<T>(static_cast<double>(points_[d]) / box_.edge[d]));
    return move;
  }
  Real place(std::size_t site, std::size_t d) const {
    return grid_place(column_[d], column_[3 + 3 * site + d], static_cast<std::int32_t>(points_[d]),
                      box_.edge[d]);
  }
  // Stores the index of the grid point below a site along one axis, and returns the site's distance
  // from this point.
  Real beyond(std::size_t site, std::size_t d, std::int32_t* index) const {
    return beyond_point(place(site, d), static_cast<std::int32_t>(points_[d]), index);
  }

 private:
  const Box& box_;
  const std::array<std::size_t, 3>& points_;
  std::size_t numbers_;
  std::array<Real, 3 + 3 * max_sites + Real::width> column_;
};

// Loads and stores records of four numbers at arbitrary addresses, one record per lane of a pack.
template <class T, class Records>
void load_four(const Records& record, Pack<T> (&number)[4]) {
  using Tiles = Tile<T>;
  for (std::size_t k = 0; k < 4; k += Tiles::columns) {
    for (std::size_t c = 0; c < Tiles::columns; ++c)
      number[k + c] =
          Tiles::gather_rows([&](std::size_t r) { return record(r * Tiles::columns + c) + k; });
    Tiles::transpose_columns(number + k);
  }
}
template <class T, class Records>
void store_four(Pack<T> (&number)[4], const Records& record) {
  using Tiles = Tile<T>;
  for (std::size_t k = 0; k < 4; k += Tiles::columns) {
    Tiles::transpose_columns(number + k);
    for (std::size_t c = 0; c < Tiles::columns; ++c)
      Tiles::scatter_rows(number[k + c],
                          [&](std::size_t r) { return record(r * Tiles::columns + c) + k; });
  }
}

// Calls f with the order of the splines as a compile-time constant.
template <class Function>
void with_order(int order, const Function& f) {
  switch (order) {
    case 4:
      return f.template operator()<4>();
    case 5:
      return f.template operator()<5>();
    case 6:
      return f.template operator()<6>();
    case 7:
      return f.template operator()<7>();
    default:
      return f.template operator()<8>();
  }
}

}  // namespace
}  // namespace polhode::POLHODE_LOOPS
