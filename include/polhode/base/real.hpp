// SPDX-License-Identifier: MIT
// What physics may ask of a number type beyond + - * /, for plain double and float. Packs and dual
// numbers overload the same names, so that a law is written once for all of them.
#pragma once

#include <cmath>

namespace polhode {

/// The truth value of a comparison of Reals: bool for numbers, a lane mask for packs.
template <class Real>
struct MaskOf {
  using type = bool;
};
template <class Real>
using Mask = typename MaskOf<Real>::type;

template <class Real>
constexpr Real select(bool condition, Real if_true, Real if_false) {
  return condition ? if_true : if_false;
}

/// Whether any lane of a mask is true: for a number, the truth itself.
constexpr bool any(bool condition) { return condition; }

using std::abs;
using std::sqrt;

/// 1/√a.
template <class Real>
Real inverse_sqrt(Real a) {
  return Real(1.0) / sqrt(a);
}

}  // namespace polhode
