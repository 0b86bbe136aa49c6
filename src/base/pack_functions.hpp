// SPDX-License-Identifier: MIT
// Elementary functions of packs, and entries of tables by lane.
#pragma once

#include <array>
#include <cstdint>

#include "base/pack.hpp"

namespace polhode {
inline namespace HWY_NAMESPACE {

/// The format of a floating-point number, and ln 2 as a sum of two parts. The first part of ln 2
/// has so few bits that its products with exponents are exact.
template <class T>
struct FloatFormat;
template <>
struct FloatFormat<double> {
  using Integer = std::int64_t;
  static constexpr int fraction_bits = 52, bias = 1023;
  static constexpr double ln2_high = 0x1.62e42feep-1, ln2_low = 0x1.a39ef35793c76p-33;
  static constexpr double min_exponent = -708, max_exponent = 709;  // range where eˣ is normal
  static constexpr int exp_degree = 13, log_terms = 10;
};
template <>
struct FloatFormat<float> {
  using Integer = std::int32_t;
  static constexpr int fraction_bits = 23, bias = 127;
  static constexpr float ln2_high = 0x1.62e3p-1F, ln2_low = 0x1.2fefa2p-17F;
  static constexpr float min_exponent = -87, max_exponent = 88;
  static constexpr int exp_degree = 7, log_terms = 5;
};

template <class T>
Pack<T> floor(Pack<T> x) {
  return Pack<T>(hn::Floor(x.v));
}

/// The exponential eˣ = 2ᵏ eʳ with an integer k and |r| ≤ ln 2/2. The truncation error of the
/// Taylor series of eʳ is below half a unit in the last place. Lane types: float, double. Largest
/// error: 1.5 ULP (tests/unit/base/pack_functions_test.cpp). Valid range: −708 to 709 for double,
/// −87 to 88 for float; outside this range, the result is the value at the nearest limit.
template <class T>
Pack<T> exp(Pack<T> x) {
  using Real = Pack<T>;
  using Format = FloatFormat<T>;
  const hn::RebindToSigned<typename Real::Tag> integers;
  x = Real(hn::Clamp(x.v, Real(Format::min_exponent).v, Real(Format::max_exponent).v));
  // The constant that is added is so large that its unit in the last place is 1. The sum is
  // therefore x rounded to an integer, and its lowest bits contain this integer.
  const Real large(static_cast<T>(1.5) *
                   static_cast<T>(typename Format::Integer{1} << Format::fraction_bits));
  const Real sum = fma(x, Real(static_cast<T>(1.4426950408889634)), large);  // x/ln 2
  const Real k = sum - large;
  const Real r = fma(k, Real(-Format::ln2_low), fma(k, Real(-Format::ln2_high), x));
  Real series(1);
  for (int n = Format::exp_degree; n > 0; --n)
    series = fma(series * r, Real(static_cast<T>(1.0 / n)), Real(1));
  const auto exponent =
      hn::Add(hn::BitCast(integers, sum.v),
              hn::Set(integers, static_cast<typename Format::Integer>(Format::bias)));
  return series *
         Real(hn::BitCast(typename Real::Tag(), hn::ShiftLeft<Format::fraction_bits>(exponent)));
}

/// The natural logarithm ln x = k ln 2 + ln m with an integer k and m from √½ to √2. The value of
/// ln m is the sum of the series of 2 artanh((m − 1)/(m + 1)). Lane types: float, double. Largest
/// error: 2.5 ULP (tests/unit/base/pack_functions_test.cpp). Valid range: positive normal numbers.
template <class T>
Pack<T> log(Pack<T> x) {
  using Real = Pack<T>;
  using Format = FloatFormat<T>;
  const hn::RebindToSigned<typename Real::Tag> integers;
  const auto offset = hn::BitCast(integers, Real(static_cast<T>(0.70710678118654752)).v);
  const auto bits = hn::BitCast(integers, x.v);
  const auto exponent = hn::ShiftRight<Format::fraction_bits>(hn::Sub(bits, offset));
  const Real k(hn::ConvertTo(typename Real::Tag(), exponent));
  const Real m(hn::BitCast(typename Real::Tag(),
                           hn::Sub(bits, hn::ShiftLeft<Format::fraction_bits>(exponent))));
  const Real s = (m - Real(1)) / (m + Real(1)), s2 = s * s;
  Real series(static_cast<T>(2.0 / (2 * Format::log_terms + 1)));
  for (int n = Format::log_terms; n-- > 1;)
    series = fma(series, s2, Real(static_cast<T>(2.0 / (2 * n + 1))));
  const Real log_m = fma(series * s2, s, s + s);
  return fma(k, Real(Format::ln2_high), fma(k, Real(Format::ln2_low), log_m));
}

/// The table entry table[index] of each lane, for indices that are whole numbers.
template <class T>
Pack<T> table_entry(const T* table, Pack<T> index) {
  const hn::RebindToSigned<typename Pack<T>::Tag> integers;
  return Pack<T>(hn::GatherIndex(typename Pack<T>::Tag(), table, hn::ConvertTo(integers, index.v)));
}

}  // namespace HWY_NAMESPACE
}  // namespace polhode
