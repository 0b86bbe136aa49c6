// SPDX-License-Identifier: MIT
// Series lengths for which Fourier transforms are fast.
#pragma once

#include <cstddef>

namespace polhode {

/// Whether a length of at least 1 is a product of 2, 3, 5 and 7.
inline bool is_smooth_size(std::size_t length) {
  for (const std::size_t prime : {2U, 3U, 5U, 7U})
    while (length % prime == 0) length /= prime;
  return length == 1;
}

/// The next product of 2, 3, 5 and 7 that is at least `min_length`, and at least 1.
inline std::size_t smooth_size(std::size_t min_length) {
  std::size_t length = min_length > 0 ? min_length : 1;
  while (!is_smooth_size(length)) ++length;
  return length;
}

}  // namespace polhode
