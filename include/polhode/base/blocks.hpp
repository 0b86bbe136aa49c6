// SPDX-License-Identifier: MIT
// Columns cut into blocks, the same ones whatever the number of threads.
#pragma once

#include <algorithm>
#include <cstddef>

#include "polhode/base/workers.hpp"

namespace polhode {

/// Bodies of a block: whole packs of any kind, and some µs of work.
inline constexpr std::size_t block_size = 512;

constexpr std::size_t blocks(std::size_t size) { return (size + block_size - 1) / block_size; }

/// Calls task(first, end) for every block of 0 ≤ i < size, `size` itself ending the last.
template <class Task>
void each_block(std::size_t size, Workers& workers, const Task& task) {
  workers.each(blocks(size),
               [&](std::size_t k) { task(k * block_size, std::min(size, (k + 1) * block_size)); });
}

}  // namespace polhode
