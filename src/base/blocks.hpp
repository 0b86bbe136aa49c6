// SPDX-License-Identifier: MIT
// Splits columns into blocks that do not depend on the number of threads.
#pragma once

#include <algorithm>
#include <cstddef>

#include "polhode/base/workers.hpp"

namespace polhode {

constexpr std::size_t blocks(std::size_t size, std::size_t block) {
  return (size + block - 1) / block;
}

/// Calls task(first, end) for every block of 0 ≤ i < size, in parallel; the last block ends at
/// `size`. A block should take a few µs, which is several times the cost of a fork and a join. The
/// block size should be a multiple of the pack width.
template <class Task>
void each_block(std::size_t size, std::size_t block, Workers& workers, const Task& task) {
  workers.each(blocks(size, block),
               [&](std::size_t k) { task(k * block, std::min(size, (k + 1) * block)); });
}

}  // namespace polhode
