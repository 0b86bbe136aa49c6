// SPDX-License-Identifier: MIT
// How rows of the neighbour list are made to fill whole packs.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "forces/pairs/neighbours.hpp"

namespace polhode {

/// The partners in a row that is being built. Memory for one more pack follows the last partner,
/// because only whole packs are stored.
class RowBuffer {
 public:
  void clear() { first_ = size_ = 0; }
  std::size_t size() const { return size_ - first_; }
  /// The end of the row, after making room for n more entries and a pack.
  std::uint32_t* end_with_room(std::size_t n) {
    if (words_.size() < size_ + n + slot_block) words_.resize(2 * (size_ + n + slot_block));
    return words_.data() + size_;
  }
  void grow(std::size_t n) { size_ += n; }  ///< Counts n entries that were written at the end.
  void push(Neighbour n) { *end_with_room(1) = n.word(), ++size_; }
  Neighbour pop() { return Neighbour(words_[--size_]); }
  void remove_first(std::size_t n) { first_ += n; }
  Neighbour operator[](std::size_t k) const { return Neighbour(words_[first_ + k]); }
  const std::uint32_t* begin() const { return words_.data() + first_; }
  const std::uint32_t* end() const { return words_.data() + size_; }

 private:
  std::vector<std::uint32_t> words_;
  std::size_t first_ = 0, size_ = 0;
};

/// Surplus pairs that rows have handed over to the rows of slots a little further ahead.
class HandedPairs {
 public:
  static constexpr std::uint32_t window = 256;  ///< number of following slots to which pairs can be
                                                ///< handed over
  static constexpr std::uint32_t room = 32;     ///< maximum number of pairs that a slot can receive

  HandedPairs() : pairs_(new std::uint32_t[window * room]), counts_(window, 0) {}

  /// Whether the row of a slot, at most `window` − 1 slots ahead, has room for n more pairs.
  bool has_room(std::uint32_t slot, std::size_t n) const {
    return counts_[slot % window] + n <= room;
  }
  void give(std::uint32_t slot, Neighbour pair) {
    pairs_[slot % window * room + counts_[slot % window]++] = pair.word();
  }
  /// Moves the pairs that a slot has received to the end of its row.
  void take(std::uint32_t slot, RowBuffer& row) {
    const std::uint32_t n = std::exchange(counts_[slot % window], 0);
    std::copy_n(&pairs_[slot % window * room], n, row.end_with_room(n));
    row.grow(n);
  }

 private:
  // `pairs_` and `counts_` are indexed by the slot modulo `window`.
  std::unique_ptr<std::uint32_t[]> pairs_;
  std::vector<std::uint32_t> counts_;
};

/// Hands the surplus pairs of a row over to the rows of their partners. The surplus pairs are the
/// first pairs of the row; their number is the row length modulo the pack width. Surplus pairs are
/// moved only if all their partners follow soon in the same chunk.
inline void hand_over(std::uint32_t slot, std::uint32_t chunk_end, std::size_t width,
                      RowBuffer& row, HandedPairs& later) {
  const std::size_t surplus = row.size() % width;
  const std::uint32_t end = std::min(chunk_end, slot + HandedPairs::window);
  for (std::size_t k = 0; k < surplus; ++k) {
    const std::uint32_t taker = row[k].slot();
    if (taker <= slot || taker >= end || !later.has_room(taker, surplus)) return;
  }
  for (std::size_t k = 0; k < surplus; ++k) later.give(row[k].slot(), {slot, -row[k].image()});
  row.remove_first(surplus);
}

}  // namespace polhode
