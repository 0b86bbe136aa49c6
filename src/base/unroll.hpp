// SPDX-License-Identifier: MIT
// Loops that are unrolled if their length is known at compile time.
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

#include "polhode/base/always_inline.hpp"

namespace polhode {

/// An integer that is encoded in its type.
template <std::size_t n>
using Count = std::integral_constant<std::size_t, n>;

/// Calls body(k) for 0 ≤ k < n, with an unrolled loop.
template <std::size_t n, class Body>
POLHODE_INLINE constexpr void each(Count<n>, const Body& body) {
  [&]<std::size_t... k>(std::index_sequence<k...>) POLHODE_INLINE_LAMBDA {
    (body(Count<k>{}), ...);
  }
  (std::make_index_sequence<n>{});
}

/// Calls body(k) for 0 ≤ k < n, with an ordinary loop.
template <class Body>
POLHODE_INLINE constexpr void each(std::size_t n, const Body& body) {
  for (std::size_t k = 0; k < n; ++k) body(k);
}

}  // namespace polhode
