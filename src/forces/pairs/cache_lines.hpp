// SPDX-License-Identifier: MIT
// Strides of the rows and planes of a grid that avoid cache conflicts.
#pragma once

#include <cstddef>

#include "base/blocks.hpp"
#include "polhode/base/column.hpp"

namespace polhode {

/// The stride for rows or planes of a given size: an odd number of cache lines. With an even number
/// of lines, the same column of successive rows would map to few sets of the cache.
template <class T>
std::size_t odd_lines(std::size_t numbers) {
  constexpr std::size_t line = pack_bytes / sizeof(T);
  return (blocks(numbers, line) | 1) * line;
}

}  // namespace polhode
