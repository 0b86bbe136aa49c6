// SPDX-License-Identifier: MIT
// How rows of the neighbour list are made to fill whole packs.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "polhode/forces/pairs/neighbours.hpp"

namespace polhode {

/// Partners of a row under construction, with room for a pack past the end, since packs are stored
/// whole.
class RowBuffer {
 public:
  void clear() { size_ = 0; }
  std::size_t size() const { return size_; }
  /// The end of the row, with room for n more entries and a pack.
  std::uint32_t* end_with_room(std::size_t n) {
    if (words_.size() < size_ + n + slot_block) words_.resize(2 * (size_ + n + slot_block));
    return &words_[size_];
  }
  void grow(std::size_t n) { size_ += n; }  ///< n entries were written at the end
  void push(Neighbour n) { *end_with_room(1) = n.word(), ++size_; }
  Neighbour pop() { return Neighbour(words_[--size_]); }
  Neighbour operator[](std::size_t k) const { return Neighbour(words_[k]); }
  /// Removes an entry; the last one takes its place.
  void remove(std::size_t k) { words_[k] = words_[--size_]; }
  const std::uint32_t* begin() const { return words_.data(); }
  const std::uint32_t* end() const { return words_.data() + size_; }

 private:
  std::vector<std::uint32_t> words_;
  std::size_t size_ = 0;
};

/// Pairs that rows have handed to later rows of the same chunk, one list per slot.
class HandedPairs {
 public:
  HandedPairs(std::uint32_t first, std::uint32_t end) : first_(first), head_(end - first, none) {}

  void give(std::uint32_t slot, Neighbour pair) {
    std::uint32_t& head = head_[slot - first_];
    links_.push_back({pair, std::exchange(head, static_cast<std::uint32_t>(links_.size()))});
  }
  /// Appends the pairs handed to a slot.
  void take(std::uint32_t slot, RowBuffer& row) const {
    for (std::uint32_t k = head_[slot - first_]; k != none; k = links_[k].next)
      row.push(links_[k].pair);
  }

 private:
  static constexpr std::uint32_t none = ~0u;
  struct Link {
    Neighbour pair;
    std::uint32_t next;
  };
  std::uint32_t first_;
  std::vector<std::uint32_t> head_;
  std::vector<Link> links_;
};

/// Hands surplus pairs of a slot's row to the rows of partners that come later in the chunk, so
/// that whole packs remain; hands over nothing if that cannot be achieved. Pairs handed to this row
/// stay here, since their partners come earlier.
inline void hand_over(std::uint32_t slot, std::uint32_t chunk_end, std::size_t width,
                      RowBuffer& row, HandedPairs& later) {
  const std::size_t surplus = row.size() % width;
  const auto can_take = [&](Neighbour n) { return n.slot() > slot && n.slot() < chunk_end; };
  std::size_t takers = 0;
  for (std::size_t k = 0; k < row.size() && takers < surplus; ++k) takers += can_take(row[k]);
  if (takers < surplus) return;
  for (std::size_t k = 0, left = surplus; left > 0;) {
    if (!can_take(row[k])) {
      ++k;
      continue;
    }
    later.give(row[k].slot(), {slot, -row[k].image()});
    row.remove(k);
    --left;
  }
}

}  // namespace polhode
