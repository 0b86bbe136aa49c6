// SPDX-License-Identifier: MIT
// Columns cut into blocks, the same ones whatever the number of threads.
#pragma once

#include <algorithm>
#include <cstddef>

#include "polhode/base/workers.hpp"

namespace polhode {

constexpr std::size_t blocks(std::size_t size, std::size_t block) {
  return (size + block - 1) / block;
}

/// Calls task(first, end) for every block of 0 ≤ i < size, `size` itself ending the last. A block
/// should be some µs of work, several times what a fork and a join cost, and hold whole packs.
template <class Task>
void each_block(std::size_t size, std::size_t block, Workers& workers, const Task& task) {
  workers.each(blocks(size, block),
               [&](std::size_t k) { task(k * block, std::min(size, (k + 1) * block)); });
}

}  // namespace polhode
