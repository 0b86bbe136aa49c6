// SPDX-License-Identifier: MIT
// Conversion between records and packs. A record holds the numbers of one body, contiguous in
// memory; a pack holds one number of each of several bodies. Each record is read by a vector load
// from an arbitrary address, and the records are transposed in registers by shuffles. A gather
// would fetch the numbers one by one. In the reverse direction, the numbers of packs are added to
// records.
#pragma once

#include <algorithm>
#include <array>

#include "base/pack.hpp"
#include "polhode/base/always_inline.hpp"

namespace polhode {
inline namespace HWY_NAMESPACE {

#if HWY_TARGET != HWY_SCALAR
/// Transposes a square of 16-byte blocks: block b of vector a goes to block a of vector b.
template <class T>
void transpose_blocks(hn::Vec<typename Pack<T>::Tag>* v) {
  [[maybe_unused]] const typename Pack<T>::Tag tag;
  constexpr std::size_t blocks = sizeof(T) * Pack<T>::width / 16;
  if constexpr (blocks == 2) {
    const auto low = hn::ConcatLowerLower(tag, v[1], v[0]);
    v[1] = hn::ConcatUpperUpper(tag, v[1], v[0]);
    v[0] = low;
  } else if constexpr (blocks == 4) {
    const auto even = [](auto x, auto y) {  // blocks 0 and 2 of x and y, interleaved
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

/// Transposes 4 × 4 floats within each 16-byte block: lane i of block b of the k-th argument goes
/// to lane k of block b of vector i.
template <class Vector>
std::array<Vector, 4> transpose_within_blocks(Vector a, Vector b, Vector c, Vector d) {
  const hn::DFromV<Vector> tag;
  const hn::RepartitionToWide<hn::DFromV<Vector>> pairs;
  const auto wide = [&](Vector v) { return hn::BitCast(pairs, v); };
  const auto ab01 = wide(hn::InterleaveLower(tag, a, b)),
             ab23 = wide(hn::InterleaveUpper(tag, a, b)),
             cd01 = wide(hn::InterleaveLower(tag, c, d)),
             cd23 = wide(hn::InterleaveUpper(tag, c, d));
  return {hn::BitCast(tag, hn::InterleaveLower(pairs, ab01, cd01)),
          hn::BitCast(tag, hn::InterleaveUpper(pairs, ab01, cd01)),
          hn::BitCast(tag, hn::InterleaveLower(pairs, ab23, cd23)),
          hn::BitCast(tag, hn::InterleaveUpper(pairs, ab23, cd23))};
}
#endif

/// Transposes a square of numbers: number k of row(i), which is a Pack, goes to lane i of
/// column[k].
template <class T, class Rows>
POLHODE_INLINE inline void transpose(const Rows& row, Pack<T>* column) {
#if HWY_TARGET == HWY_SCALAR
  column[0] = row(0);
#else
  using Vector = hn::Vec<typename Pack<T>::Tag>;
  const typename Pack<T>::Tag tag;
  constexpr std::size_t width = Pack<T>::width, side = 16 / sizeof(T);  // numbers per block
  Vector part[side][width / side];  // [column within a block][group of rows]
  for (std::size_t g = 0; g < width / side; ++g) {
    if constexpr (side == 2) {
      const Vector a = row(2 * g).v, b = row(2 * g + 1).v;
      part[0][g] = hn::InterleaveLower(tag, a, b);
      part[1][g] = hn::InterleaveUpper(tag, a, b);
    } else {
      const auto transposed = transpose_within_blocks(row(4 * g).v, row(4 * g + 1).v,
                                                      row(4 * g + 2).v, row(4 * g + 3).v);
      for (std::size_t k = 0; k < side; ++k) part[k][g] = transposed[k];
    }
  }
  for (std::size_t k = 0; k < side; ++k) {
    transpose_blocks<T>(part[k]);
    for (std::size_t b = 0; b < width / side; ++b) column[side * b + k] = Pack<T>(part[k][b]);
  }
#endif
}

/// The number of packs of doubles that hold the converted floats of one pack.
inline constexpr std::size_t halves = Pack<float>::width / Pack<double>::width;
inline std::array<Pack<double>, halves> promote(Pack<float> a) {
  const Pack<double>::Tag tag;
#if HWY_TARGET == HWY_SCALAR
  return {Pack<double>(hn::PromoteTo(tag, a.v))};
#else
  const hn::Half<Pack<float>::Tag> half;
  return {Pack<double>(hn::PromoteTo(tag, hn::LowerHalf(half, a.v))),
          Pack<double>(hn::PromoteTo(tag, hn::UpperHalf(half, a.v)))};
#endif
}
inline std::array<Pack<double>, 1> promote(Pack<double> a) { return {a}; }

/// The stride of records. A record has room for eight numbers, in as many vectors as necessary.
inline constexpr std::size_t record_stride = 8;
template <class T>
using RecordTag = hn::CappedTag<T, record_stride>;
template <class T>
using RecordPart = hn::Vec<RecordTag<T>>;
template <class T>
inline constexpr std::size_t record_part_width = std::min(record_stride, Pack<T>::width);
template <std::size_t columns, class T>
inline constexpr std::size_t record_parts =
    (columns + record_part_width<T> - 1) / record_part_width<T>;

/// Transposes columns into one record per lane. A record consists of vectors: visit(lane, part,
/// vector) receives vector `part` of the record of `lane`. Unused numbers of a record are zero.
template <std::size_t columns, class T, class Visit>
POLHODE_INLINE inline void visit_records(const std::array<Pack<T>, columns>& column,
                                         const Visit& visit) {
  static_assert(columns <= record_stride);
  constexpr std::size_t width = Pack<T>::width;
  const auto number = [&](std::size_t k) { return k < columns ? column[k] : Pack<T>(); };
  if constexpr (width <= record_stride) {
    for (std::size_t part = 0; part < record_parts<columns, T>; ++part) {
      Pack<T> row[width];
      transpose<T>([&](std::size_t k) { return number(part * width + k); }, row);
      for (std::size_t i = 0; i < width; ++i) visit(i, part, row[i].v);
    }
  } else {  // sixteen records, each of them half a pack wide
#if HWY_TARGET != HWY_SCALAR
    const auto four = [&](std::size_t k) {
      return transpose_within_blocks(number(k).v, number(k + 1).v, number(k + 2).v,
                                     number(k + 3).v);
    };
    const auto first = four(0), last = four(4);
    for (std::size_t i = 0; i < 4; ++i) {
      const auto even = hn::OddEvenBlocks(hn::SwapAdjacentBlocks(last[i]), first[i]);
      const auto odd = hn::OddEvenBlocks(last[i], hn::SwapAdjacentBlocks(first[i]));
      const RecordTag<T> half;
      visit(i, 0, hn::LowerHalf(half, even));
      visit(i + 4, 0, hn::LowerHalf(half, odd));
      visit(i + 8, 0, hn::UpperHalf(half, even));
      visit(i + 12, 0, hn::UpperHalf(half, odd));
    }
#endif
  }
}

template <class T>
void add_to_record(RecordPart<T> what, T* part) {
  const RecordTag<T> tag;
  hn::Store(hn::Add(hn::Load(tag, part), what), tag, part);
}

/// Adds lane i of column k to number k of record i. Records are processed in sequence, because two
/// lanes may refer to the same record. `record(i)` is a pointer to a record, aligned to the record
/// stride.
template <std::size_t columns, class T, class Records>
POLHODE_INLINE inline void add_to_records(const std::array<Pack<T>, columns>& value,
                                          const Records& record) {
  visit_records(value, [&](std::size_t lane, std::size_t part, RecordPart<T> row) {
    add_to_record<T>(row, record(lane) + part * record_part_width<T>);
  });
}

/// Adds the sum over the lanes of each column k to number k of one record.
template <std::size_t columns, class T>
POLHODE_INLINE inline void add_sums_to_record(const std::array<Pack<T>, columns>& value,
                                              T* record) {
  constexpr std::size_t parts = record_parts<columns, T>;
  RecordPart<T> sum[parts][2];  // of even and odd lanes, for shorter dependency chains
  for (auto& part : sum) part[0] = part[1] = hn::Zero(RecordTag<T>());
  visit_records(value, [&](std::size_t lane, std::size_t part, RecordPart<T> row) {
    sum[part][lane % 2] = hn::Add(sum[part][lane % 2], row);
  });
  for (std::size_t part = 0; part < parts; ++part)
    add_to_record<T>(hn::Add(sum[part][0], sum[part][1]), record + part * record_part_width<T>);
}

}  // namespace HWY_NAMESPACE
}  // namespace polhode
