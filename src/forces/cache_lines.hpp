// SPDX-License-Identifier: MIT
// Distances between rows and planes of a grid.
#pragma once

#include <cstddef>

#include "polhode/base/blocks.hpp"
#include "polhode/base/column.hpp"

namespace polhode {

/// Room for so many numbers in whole cache lines, not a multiple of four of them: what stands at
/// equal places of rows so far apart does not share few sets of a cache.
template <class T>
std::size_t spread_lines(std::size_t numbers) {
  constexpr std::size_t line = pack_bytes / sizeof(T);
  const std::size_t count = blocks(numbers, line);
  return (count % 4 == 0 ? count + 1 : count) * line;
}

/// The same with an odd number of lines: for planes, of which many more are read in turn.
template <class T>
std::size_t odd_lines(std::size_t numbers) {
  constexpr std::size_t line = pack_bytes / sizeof(T);
  return (blocks(numbers, line) | 1) * line;
}

}  // namespace polhode
