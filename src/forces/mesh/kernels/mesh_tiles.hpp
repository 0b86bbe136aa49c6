// SPDX-License-Identifier: MIT
// The tiles of the grid around a charge, and the weights of their points.
#pragma once

#include "base/unroll.hpp"
#include "math/b_spline.hpp"
#include "mesh_positions.hpp"
#include "polhode/base/always_inline.hpp"

namespace polhode::POLHODE_LOOPS {
namespace {

// Weights of `order` grid points along an edge for each charge of a pack, padded with zeros. The
// first tile begins up to three points before the first weighted point, and the last tile ends up
// to three points after the last weighted point.
template <class T>
class TileWeights {
 public:
  template <std::size_t order>
  void set(const Pack<T> (&weight)[order]) {
    std::array<Pack<T>, order> column;
    std::copy_n(weight, order, column.begin());
    visit_records(column, [&](std::size_t lane, std::size_t part, RecordPart<T> numbers) {
      hn::StoreU(numbers, RecordTag<T>(),
                 values_ + lane * stride + before + part * record_part_width<T>);
    });
  }
  // Returns the weights of a charge, beginning with its first weighted point.
  const T* operator()(std::size_t lane) const { return values_ + lane * stride + before; }

 private:
  static constexpr std::size_t before = 4, stride = 16;
  alignas(pack_bytes) T values_[Pack<T>::width * stride] = {};
};

// The spline weights along all edges, and the first `derivatives` derivatives of the weights.
template <class T, std::size_t order, std::size_t derivatives>
class ChargeWeights {
 public:
  // Computes the weights from the distances u of the charges beyond their grid points, in grid
  // spacings. The weights along x are multiplied by `factor`.
  void set(const Vec3<Pack<T>>& u, const Pack<T>& factor = Pack<T>(1)) {
    for (std::size_t d = 0; d < 3; ++d) {
      Pack<T> w[3][order];
      b_spline<order>(u[d], w[0], w[1], derivatives == 2 ? w[2] : nullptr);
      for (std::size_t n = 0; n <= derivatives; ++n) {
        if (d == 0)
          for (Pack<T>& weight : w[n]) weight *= factor;
        weights_[d][n].set(w[n]);
      }
    }
  }
  // The weights of the n-th derivative along edge d.
  const T* operator()(std::size_t d, std::size_t n, std::size_t lane) const {
    return weights_[d][n](lane);
  }

 private:
  TileWeights<T> weights_[3][derivatives + 1];
};

// The number of tiles along an edge that contain any of `order` consecutive points. A tile has
// `length` points, and the first tile begins `offset` points before the first weighted point. If
// the number of tiles varies little, its largest value is used for all charges, as a constant.
template <std::size_t order, std::size_t length>
struct TileCount {
  static constexpr std::size_t max = (order + 2 * length - 2) / length;
  static constexpr bool varies = length == 4 && max == 3;
  static std::size_t of(std::size_t offset) {
    return varies ? (offset + order + length - 1) / length : max;
  }
};

// The grid indices of the first weighted point, for each charge of a pack.
template <class T>
using GridIndex = std::int32_t[3][Pack<T>::width];

// The tiles around a charge: tile i along x and j along y begins at stack(i, j).
template <class T, std::size_t order>
struct TilesAround {
  using Columns = TileCount<order, Tile<T>::columns>;
  using Rows = TileCount<order, Tile<T>::rows>;

  std::size_t offset_x, offset_y, columns, rows;
  const std::ptrdiff_t *stack_at, *row_at;
  std::ptrdiff_t z;

  TilesAround(const MeshGrid<T>& grid, const GridIndex<T>& index, std::size_t lane)
      : offset_x(static_cast<std::size_t>(index[0][lane]) % Tile<T>::columns),
        offset_y(static_cast<std::size_t>(index[1][lane]) % Tile<T>::rows),
        columns(Columns::of(offset_x)),
        rows(Rows::of(offset_y)),
        stack_at(grid.stack_at.data() + index[0][lane]),
        row_at(grid.row_at.data() + index[1][lane]),
        z(index[2][lane] * static_cast<std::ptrdiff_t>(Pack<T>::width)) {}

  std::ptrdiff_t stack(std::size_t i, std::size_t j) const {
    return row_at[j * Tile<T>::rows] + stack_at[i * Tile<T>::columns] + z;
  }
  // Weights along x in tile i times weights along y in tile j.
  Pack<T> along_x(const T* weights, std::size_t i) const {
    return Tile<T>::each_column(weights + i * Tile<T>::columns - offset_x);
  }
  Pack<T> along_y(const T* weights, std::size_t j) const {
    return Tile<T>::each_row(weights + j * Tile<T>::rows - offset_y);
  }
  // Loops over tiles. The loops are unrolled if the number of tiles is constant.
  template <class Body>
  POLHODE_INLINE void each_column(const Body& body) const {
    if constexpr (Columns::varies)
      for (std::size_t i = 0; i < columns; ++i) body(i);
    else
      each(Count<Columns::max>{}, body);
  }
  template <class Body>
  POLHODE_INLINE void each_row(const Body& body) const {
    for (std::size_t j = 0; j < rows; ++j) body(j);
  }
};

// Prefetches the tiles around a charge that is processed later.
template <class T, std::size_t order, bool write>
POLHODE_INLINE inline void prefetch_tiles(const MeshGrid<T>& grid, const GridIndex<T>& index,
                                          std::size_t lane) {
  const TilesAround<T, order> tiles(grid, index, lane);
  tiles.each_row([&](std::size_t j) {
    tiles.each_column([&](std::size_t i) POLHODE_INLINE_LAMBDA {
      const T* const stack = grid.values.data() + tiles.stack(i, j);
      for (std::size_t k = 0; k < order; ++k) __builtin_prefetch(stack + k * Pack<T>::width, write);
    });
  });
}

}  // namespace
}  // namespace polhode::POLHODE_LOOPS
