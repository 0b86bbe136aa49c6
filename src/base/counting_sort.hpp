// SPDX-License-Identifier: MIT
// Sorting by a small whole number, such as the cell of a grid.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>

namespace polhode {

/// Counting sort in linear time. Items with the same key stay in their original order.
///
/// @param ends   one number per key; after the call, one more than the last place of the items with
///   this key
/// @param first  place of the first item
/// @param each   function that calls its argument with (key, item...) for every item. This function
///   is called twice and must give the same items in the same order
/// @param enter  called once per item, as enter(place, item...)
template <class Each, class Enter>
void counting_sort(std::span<std::uint32_t> ends, std::uint32_t first, const Each& each,
                   const Enter& enter) {
  std::fill(ends.begin(), ends.end(), 0);
  each([&](std::size_t key, const auto&...) { ++ends[key]; });
  // Each end begins as the first place of its key, and is incremented when an item with this key is
  // entered.
  std::exclusive_scan(ends.begin(), ends.end(), ends.begin(), first);
  each([&](std::size_t key, const auto&... item) { enter(ends[key]++, item...); });
}

/// The first place of a key, computed from the ends of counting_sort().
inline std::uint32_t begin_of(std::span<const std::uint32_t> ends, std::size_t key,
                              std::uint32_t first = 0) {
  return key == 0 ? first : ends[key - 1];
}

}  // namespace polhode
