// SPDX-License-Identifier: MIT
// Packs from and to records. Records that lie anywhere in memory are read as rows, a vector load
// each, and turned into packs with one number of every record by shuffles in registers; a gather
// would fetch numbers one by one. The way back adds packs to records.
#pragma once

#include <array>

#include "polhode/base/pack.hpp"

namespace polhode {
inline namespace HWY_NAMESPACE {

#if HWY_TARGET != HWY_SCALAR
/// Turns a square of 16-byte blocks: block b of vector a goes to block a of vector b.
template <class T>
void transpose_blocks(hn::Vec<typename Pack<T>::Tag>* v) {
  [[maybe_unused]] const typename Pack<T>::Tag tag;
  constexpr std::size_t blocks = sizeof(T) * Pack<T>::width / 16;
  if constexpr (blocks == 2) {
    const auto low = hn::ConcatLowerLower(tag, v[1], v[0]);
    v[1] = hn::ConcatUpperUpper(tag, v[1], v[0]);
    v[0] = low;
  } else if constexpr (blocks == 4) {
    const auto even = [](auto x, auto y) {  // blocks 0 and 2 of x and y in turn
      return hn::OddEvenBlocks(hn::SwapAdjacentBlocks(y), x);
    };
    const auto odd = [](auto x, auto y) { return hn::OddEvenBlocks(y, hn::SwapAdjacentBlocks(x)); };
    const auto e01 = even(v[0], v[1]), o01 = odd(v[0], v[1]);
    const auto e23 = even(v[2], v[3]), o23 = odd(v[2], v[3]);
    v[0] = hn::ConcatLowerLower(tag, e23, e01);
    v[1] = hn::ConcatLowerLower(tag, o23, o01);
    v[2] = hn::ConcatUpperUpper(tag, e23, e01);
    v[3] = hn::ConcatUpperUpper(tag, o23, o01);
  }
}
#endif

/// Turns a square of numbers: number k of row(i) goes to lane i of column[k]. `row` yields a Pack.
template <class T, class Rows>
[[gnu::always_inline]] inline void transpose(const Rows& row, Pack<T>* column) {
#if HWY_TARGET == HWY_SCALAR
  column[0] = row(0);
#else
  using Vector = hn::Vec<typename Pack<T>::Tag>;
  const typename Pack<T>::Tag tag;
  constexpr std::size_t width = Pack<T>::width, side = 16 / sizeof(T);  // numbers in a block
  Vector part[side][width / side];  // [column within a block][group of rows]
  for (std::size_t g = 0; g < width / side; ++g) {
    if constexpr (side == 2) {
      const Vector a = row(2 * g).v, b = row(2 * g + 1).v;
      part[0][g] = hn::InterleaveLower(tag, a, b);
      part[1][g] = hn::InterleaveUpper(tag, a, b);
    } else {
      const hn::RepartitionToWide<typename Pack<T>::Tag> pairs;
      const auto wide = [&](Vector v) { return hn::BitCast(pairs, v); };
      const Vector a = row(4 * g).v, b = row(4 * g + 1).v, c = row(4 * g + 2).v,
                   d = row(4 * g + 3).v;
      const auto ab01 = wide(hn::InterleaveLower(tag, a, b)),
                 ab23 = wide(hn::InterleaveUpper(tag, a, b)),
                 cd01 = wide(hn::InterleaveLower(tag, c, d)),
                 cd23 = wide(hn::InterleaveUpper(tag, c, d));
      part[0][g] = hn::BitCast(tag, hn::InterleaveLower(pairs, ab01, cd01));
      part[1][g] = hn::BitCast(tag, hn::InterleaveUpper(pairs, ab01, cd01));
      part[2][g] = hn::BitCast(tag, hn::InterleaveLower(pairs, ab23, cd23));
      part[3][g] = hn::BitCast(tag, hn::InterleaveUpper(pairs, ab23, cd23));
    }
  }
  for (std::size_t k = 0; k < side; ++k) {
    transpose_blocks<T>(part[k]);
    for (std::size_t b = 0; b < width / side; ++b) column[side * b + k] = Pack<T>(part[k][b]);
  }
#endif
}

/// A pack of floats as packs of doubles.
inline constexpr std::size_t halves = Pack<float>::width / Pack<double>::width;
inline std::array<Pack<double>, halves> widened(Pack<float> a) {
  const Pack<double>::Tag tag;
#if HWY_TARGET == HWY_SCALAR
  return {Pack<double>(hn::PromoteTo(tag, a.v))};
#else
  const hn::Half<Pack<float>::Tag> half;
  return {Pack<double>(hn::PromoteTo(tag, hn::LowerHalf(half, a.v))),
          Pack<double>(hn::PromoteTo(tag, hn::UpperHalf(half, a.v)))};
#endif
}
inline std::array<Pack<double>, 1> widened(Pack<double> a) { return {a}; }

/// Packs of doubles that a record of so many numbers takes.
template <std::size_t columns>
inline constexpr std::size_t record_packs =
    (columns + Pack<double>::width - 1) / Pack<double>::width;

/// Turns columns into records: visit(lane, part, pack) gets the numbers part · width and on of the
/// record of a lane; a record ends in zeros.
template <std::size_t columns, class Visit>
[[gnu::always_inline]] inline void visit_records(const std::array<Pack<double>, columns>& column,
                                                 const Visit& visit) {
  constexpr std::size_t width = Pack<double>::width;
  for (std::size_t part = 0; part < record_packs<columns>; ++part) {
    Pack<double> row[width];
    transpose<double>(
        [&](std::size_t k) {
          return part * width + k < columns ? column[part * width + k] : Pack<double>();
        },
        row);
    for (std::size_t i = 0; i < width; ++i) visit(i, part, row[i]);
  }
}

/// Adds lane i of column k to number k of record i, for records of doubles that are aligned as a
/// pack; one after the other, as two lanes may mean the same record. `record` yields a pointer.
template <std::size_t columns, class T, class Records>
[[gnu::always_inline]] inline void add_to_records(const std::array<Pack<T>, columns>& value,
                                                  const Records& record) {
  constexpr std::size_t width = Pack<double>::width;
  for (std::size_t h = 0; h < Pack<T>::width / width; ++h) {
    std::array<Pack<double>, columns> column;
    for (std::size_t k = 0; k < columns; ++k) column[k] = widened(value[k])[h];
    visit_records(column, [&](std::size_t lane, std::size_t part, Pack<double> row) {
      double* const sums = record(h * width + lane) + part * width;
      (Pack<double>::load(sums) + row).store(sums);
    });
  }
}

/// Adds the sum over the lanes of column k to number k of one record.
template <std::size_t columns, class T>
[[gnu::always_inline]] inline void add_sums_to_record(const std::array<Pack<T>, columns>& value,
                                                      double* record) {
  constexpr std::size_t width = Pack<double>::width;
  std::array<Pack<double>, columns> column;
  for (std::size_t k = 0; k < columns; ++k)
    for (const Pack<double>& half : widened(value[k])) column[k] += half;
  Pack<double> sum[record_packs<columns>][2];  // even and odd lanes apart: a shorter chain
  visit_records(column, [&](std::size_t lane, std::size_t part, Pack<double> row) {
    sum[part][lane % 2] += row;
  });
  for (std::size_t part = 0; part < record_packs<columns>; ++part) {
    double* const at = record + part * width;
    (Pack<double>::load(at) + (sum[part][0] + sum[part][1])).store(at);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace polhode
