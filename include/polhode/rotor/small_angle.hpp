// SPDX-License-Identifier: MIT
// Sine and cosine of small angles, for packs.
#pragma once

#include <cstddef>

#include "polhode/base/real.hpp"
#include "polhode/rotor/series.hpp"

namespace polhode {

/// Returns sin x and cos x, or sin(x)/x and cos x.
template <class Real>
struct SineCosine {
  Real sine, cosine;
};

/// Computes sin(x)/x and cos x from y = x² by their Taylor series, innermost terms first. The first
/// omitted terms are y^m/(2m + 1)! with m = sine_terms + 1, and y^m/(2m)! with m = cosine_terms +
/// 1.
template <std::size_t sine_terms, std::size_t cosine_terms, class Real>
SineCosine<Real> taylor_sine_cosine(Real y) {
  const Real one(1);
  Real sine = one, cosine = one;
  series::unroll<sine_terms>([&](auto count) {
    constexpr double n = sine_terms - static_cast<double>(count);
    sine = one - y * constant<Real>(1 / (2 * n * (2 * n + 1))) * sine;
  });
  series::unroll<cosine_terms>([&](auto count) {
    constexpr double n = cosine_terms - static_cast<double>(count);
    cosine = one - y * constant<Real>(1 / (2 * n * (2 * n - 1))) * cosine;
  });
  return {sine, cosine};
}

}  // namespace polhode
