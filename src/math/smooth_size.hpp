// SPDX-License-Identifier: MIT
// Series lengths for which Fourier transforms are fast.
#pragma once

#include <cstddef>

namespace polhode {

/// The next product of 2, 3, 5 and 7 that is at least `min_length`, and at least 1.
inline std::size_t smooth_size(std::size_t min_length) {
  for (std::size_t n = min_length > 0 ? min_length : 1;; ++n) {
    std::size_t rest = n;
    for (const std::size_t prime : {2U, 3U, 5U, 7U})
      while (rest % prime == 0) rest /= prime;
    if (rest == 1) return n;
  }
}

}  // namespace polhode
