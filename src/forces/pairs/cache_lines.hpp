// SPDX-License-Identifier: MIT
// Strides of the rows and planes of a grid that avoid cache conflicts.
#pragma once

#include <cstddef>

#include "base/blocks.hpp"
#include "polhode/base/column.hpp"

namespace polhode {

/// The stride for rows of that length, in whole cache lines but not a multiple of four of them: the
/// same column of successive rows would otherwise map to few sets of the cache.
template <class T>
std::size_t spread_lines(std::size_t numbers) {
  constexpr std::size_t line = pack_bytes / sizeof(T);
  const std::size_t count = blocks(numbers, line);
  return (count % 4 == 0 ? count + 1 : count) * line;
}

/// The same with an odd number of lines: for planes, many more of which are read one after another.
template <class T>
std::size_t odd_lines(std::size_t numbers) {
  constexpr std::size_t line = pack_bytes / sizeof(T);
  return (blocks(numbers, line) | 1) * line;
}

}  // namespace polhode
