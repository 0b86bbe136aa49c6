// SPDX-License-Identifier: MIT
// Packs on a grid. Packs of grid points (tiles), and packs of positions on the grid. A tile is a
// rectangle of grid points in one pack, with `rows` rows of `columns` points.
#pragma once

#include <algorithm>

#include "base/pack_integers.hpp"

namespace polhode {
inline namespace HWY_NAMESPACE {

/// Element r columns + c of a pack is the point in row r and column c.
template <class T>
struct Tile {
  using Real = Pack<T>;
  static constexpr std::size_t columns = std::min<std::size_t>(4, Real::width);
  static constexpr std::size_t rows = Real::width / columns;

  /// Returns p[c] in column c of every row.
  static Real each_column(const T* p) {
    return gather_rows([&](std::size_t) { return p; });
  }
  /// Returns p[r] in row r of every column.
  static Real each_row(const T* p) {
    if constexpr (rows == 1) {
      return Real(*p);
#if HWY_TARGET != HWY_SCALAR
    } else if constexpr (rows == 2) {
      const hn::Half<Tag> half;
      return Real(hn::Combine(Tag(), hn::Set(half, p[1]), hn::Set(half, p[0])));
    } else {
      alignas(64) static constexpr std::int32_t row_of[] = {0, 0, 0, 0, 1, 1, 1, 1,
                                                            2, 2, 2, 2, 3, 3, 3, 3};
      const auto index = hn::IndicesFromVec(Tag(), hn::Load(typename Real::IndexTag(), row_of));
      return Real(hn::TableLookupLanes(hn::LoadDup128(Tag(), p), index));
#endif
    }
  }

  /// Loads each row r from consecutive numbers that begin at row(r).
  template <class Rows>
  static Real gather_rows(const Rows& row) {
    const Row tag;
    if constexpr (rows == 1) {
      return Real(hn::LoadU(tag, row(0)));
#if HWY_TARGET != HWY_SCALAR
    } else if constexpr (rows == 2) {
      return Real(hn::Combine(Tag(), hn::LoadU(tag, row(1)), hn::LoadU(tag, row(0))));
    } else {
      const hn::Half<Tag> half;
      const auto low = hn::Combine(half, hn::LoadU(tag, row(1)), hn::LoadU(tag, row(0)));
      const auto high = hn::Combine(half, hn::LoadU(tag, row(3)), hn::LoadU(tag, row(2)));
      return Real(hn::Combine(Tag(), high, low));
#endif
    }
  }
  /// Stores each row r as consecutive numbers that begin at row(r).
  template <class Rows>
  static void scatter_rows(Real tile, const Rows& row) {
    const Row tag;
    if constexpr (rows == 1) {
      hn::StoreU(tile.v, tag, row(0));
#if HWY_TARGET != HWY_SCALAR
    } else if constexpr (rows == 2) {
      hn::StoreU(hn::LowerHalf(tag, tile.v), tag, row(0));
      hn::StoreU(hn::UpperHalf(tag, tile.v), tag, row(1));
    } else {
      const hn::Half<Tag> half;
      const auto low = hn::LowerHalf(half, tile.v), high = hn::UpperHalf(half, tile.v);
      hn::StoreU(hn::LowerHalf(tag, low), tag, row(0));
      hn::StoreU(hn::UpperHalf(tag, low), tag, row(1));
      hn::StoreU(hn::LowerHalf(tag, high), tag, row(2));
      hn::StoreU(hn::UpperHalf(tag, high), tag, row(3));
#endif
    }
  }

  /// Transposes the columns of `columns` tiles: column c of tile k becomes column k of tile c.
  static void transpose_columns([[maybe_unused]] Real* tile) {
#if HWY_TARGET != HWY_SCALAR
    if constexpr (columns == 2) {
      const Real first = tile[0], second = tile[1];
      tile[0] = Real(hn::InterleaveLower(Tag(), first.v, second.v));
      tile[1] = Real(hn::InterleaveUpper(Tag(), first.v, second.v));
    } else if constexpr (columns == 4 && sizeof(T) == 4) {
      const auto turned = transpose_within_blocks(tile[0].v, tile[1].v, tile[2].v, tile[3].v);
      for (std::size_t k = 0; k < columns; ++k) tile[k] = Real(turned[k]);
    } else if constexpr (columns == 4) {  // two numbers per block, two blocks per row
      const auto low = [&](std::size_t k) {
        return hn::InterleaveLower(Tag(), tile[k].v, tile[k + 1].v);
      };
      const auto high = [&](std::size_t k) {
        return hn::InterleaveUpper(Tag(), tile[k].v, tile[k + 1].v);
      };
      const auto low01 = low(0), low23 = low(2), high01 = high(0), high23 = high(2);
      const auto even = [](auto a, auto b) {
        return Real(hn::OddEvenBlocks(hn::SwapAdjacentBlocks(b), a));
      };
      const auto odd = [](auto a, auto b) {
        return Real(hn::OddEvenBlocks(b, hn::SwapAdjacentBlocks(a)));
      };
      tile[0] = even(low01, low23), tile[1] = even(high01, high23);
      tile[2] = odd(low01, low23), tile[3] = odd(high01, high23);
    }
#endif
  }
  /// Transposes the rows of `rows` tiles: row r of tile k becomes row k of tile r.
  static void transpose_rows([[maybe_unused]] Real* tile) {
#if HWY_TARGET != HWY_SCALAR
    if constexpr (rows == 2) {
      const Real first = tile[0], second = tile[1];
      tile[0] = Real(hn::ConcatLowerLower(Tag(), second.v, first.v));
      tile[1] = Real(hn::ConcatUpperUpper(Tag(), second.v, first.v));
    } else if constexpr (rows == 4) {
      hn::Vec<Tag> v[rows] = {tile[0].v, tile[1].v, tile[2].v, tile[3].v};
      transpose_blocks<T>(v);
      for (std::size_t r = 0; r < rows; ++r) tile[r] = Real(v[r]);
    }
#endif
  }

 private:
  using Tag = typename Real::Tag;
  using Row = hn::CappedTag<T, columns>;
};

/// The positions of points along a box edge in units of the grid spacing, from 0 to `points` up to
/// round-off. A point is the sum of a centre and an arm [nm], in any periodic image.
inline Pack<double> grid_place(Pack<double> centre, Pack<double> arm, std::int32_t points,
                               double edge) {
  const Pack<double> t = (centre + arm) * Pack<double>(points / edge);
  return t - Pack<double>(points) * Pack<double>(hn::Floor((t * Pack<double>(1.0 / points)).v));
}

/// The positions of points along a box edge as fixed-point numbers, held as the bits of a pack. The
/// unit is 2⁻³⁰ of the edge. The centre is also a fixed-point number.
inline Pack<float> grid_place(Pack<float> centre, Pack<float> arm, std::int32_t, double edge) {
  const FixedTag fixed;
  constexpr std::int32_t unit = 1 << 30;
  const Pack<float> in_units = arm * Pack<float>(static_cast<float>(unit / edge));
  const auto x = hn::And(hn::Add(hn::BitCast(fixed, centre.v), hn::NearestInt(in_units.v)),
                         hn::Set(fixed, unit - 1));
  return Pack<float>(hn::BitCast(Pack<float>::Tag(), x));
}

/// Stores the index of the grid point below each position. Returns the distance from this point to
/// the position, from 0 to 1 up to round-off.
inline Pack<double> beyond_point(Pack<double> place, std::int32_t points, std::int32_t* index) {
  const Pack<double> n(points), before(hn::Floor(place.v));
  const Pack<double> wrapped =  // round-off may have given −1 or n
      select(before < n, select(before < Pack<double>(0), n - Pack<double>(1), before),
             Pack<double>(0));
  const hn::Rebind<std::int32_t, Pack<double>::Tag> narrow;
  hn::StoreU(hn::DemoteTo(narrow, wrapped.v), narrow, index);
  return place - before;
}

/// The distance beyond the grid point has only one round-off error, because the integer part is
/// computed modulo 2³².
inline Pack<float> beyond_point(Pack<float> place, std::int32_t points, std::int32_t* index) {
  const Pack<float>::Tag tag;
  const FixedTag fixed;
  const auto x = hn::BitCast(fixed, place.v);
  const Pack<float> t =
      Pack<float>(hn::ConvertTo(tag, x)) * Pack<float>(static_cast<float>(points) * 0x1p-30f);
  const auto before = hn::ConvertTo(fixed, t.v);
  const auto n = hn::Set(fixed, points);
  const auto beyond = hn::Sub(hn::Mul(x, n), hn::ShiftLeft<30>(before));
  hn::StoreU(hn::IfThenElse(hn::Lt(before, n), before, hn::Zero(fixed)), fixed, index);
  return Pack<float>(hn::ConvertTo(tag, beyond)) * Pack<float>(0x1p-30f);
}

}  // namespace HWY_NAMESPACE
}  // namespace polhode
