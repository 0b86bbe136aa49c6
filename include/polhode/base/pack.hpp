// SPDX-License-Identifier: MIT
// Packs: as many numbers as the instruction set handles at once, behaving as one Real. The only
// file with vector types. It is included by files that are compiled once per instruction set (the
// `targets` folders), each with its own compiler flags.
#pragma once

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "polhode/base/quaternion.hpp"
#include "polhode/base/vec3.hpp"

namespace polhode {
inline namespace HWY_NAMESPACE {  // packs of different instruction sets are different types

namespace hn = hwy::HWY_NAMESPACE;

/// The largest pack of doubles or floats of this instruction set.
template <class T>
struct Pack {
  using value_type = T;
  using Tag = hn::ScalableTag<T>;
  using IndexTag = hn::RebindToSigned<Tag>;
  using Index = hn::Vec<IndexTag>;
  static constexpr std::size_t width = HWY_LANES(T);

  hn::Vec<Tag> v;

  Pack() : v(hn::Zero(Tag())) {}
  Pack(T value) : v(hn::Set(Tag(), value)) {}  // implicit, as a Real is made of a literal
  Pack(hn::Vec<Tag> value) requires(!std::is_same_v<hn::Vec<Tag>, T>) : v(value) {}

  static Pack load(const T* p) { return Pack(hn::Load(Tag(), p)); }
  void store(T* p) const { hn::Store(v, Tag(), p); }

  friend Pack operator+(Pack a, Pack b) { return Pack(hn::Add(a.v, b.v)); }
  friend Pack operator-(Pack a, Pack b) { return Pack(hn::Sub(a.v, b.v)); }
  friend Pack operator*(Pack a, Pack b) { return Pack(hn::Mul(a.v, b.v)); }
  friend Pack operator/(Pack a, Pack b) { return Pack(hn::Div(a.v, b.v)); }
  friend Pack operator-(Pack a) { return Pack(hn::Neg(a.v)); }
  Pack& operator+=(Pack b) { return *this = *this + b; }
  Pack& operator-=(Pack b) { return *this = *this - b; }
  Pack& operator*=(Pack b) { return *this = *this * b; }
};

/// The truth of a comparison, lane by lane.
template <class T>
struct PackMask {
  hn::Mask<typename Pack<T>::Tag> m;
  friend PackMask operator&&(PackMask a, PackMask b) { return {hn::And(a.m, b.m)}; }
  friend PackMask operator||(PackMask a, PackMask b) { return {hn::Or(a.m, b.m)}; }
  friend PackMask operator!(PackMask a) { return {hn::Not(a.m)}; }
};

template <class T>
PackMask<T> operator<(Pack<T> a, Pack<T> b) {
  return {hn::Lt(a.v, b.v)};
}
template <class T>
PackMask<T> operator>(Pack<T> a, Pack<T> b) {
  return {hn::Gt(a.v, b.v)};
}
template <class T>
PackMask<T> operator<=(Pack<T> a, Pack<T> b) {
  return {hn::Le(a.v, b.v)};
}
template <class T>
PackMask<T> operator>=(Pack<T> a, Pack<T> b) {
  return {hn::Ge(a.v, b.v)};
}

template <class T>
bool any(PackMask<T> mask) {
  return !hn::AllFalse(typename Pack<T>::Tag(), mask.m);
}
template <class T>
bool all(PackMask<T> mask) {
  return hn::AllTrue(typename Pack<T>::Tag(), mask.m);
}
/// The first `count` lanes.
template <class T>
PackMask<T> first_lanes(std::size_t count) {
  return {hn::FirstN(typename Pack<T>::Tag(), count)};
}
template <class T>
Pack<T> select(PackMask<T> mask, Pack<T> if_true, Pack<T> if_false) {
  return Pack<T>(hn::IfThenElse(mask.m, if_true.v, if_false.v));
}

template <class T>
Pack<T> sqrt(Pack<T> a) {
  return Pack<T>(hn::Sqrt(a.v));
}
template <class T>
Pack<T> abs(Pack<T> a) {
  return Pack<T>(hn::Abs(a.v));
}
/// a b + c with one rounding where the hardware has it.
template <class T>
Pack<T> fma(Pack<T> a, Pack<T> b, Pack<T> c) {
  return Pack<T>(hn::MulAdd(a.v, b.v, c.v));
}
/// 1/√a to about one unit in the last place, for a within the range of floats: the hardware's
/// estimate y of 11 bits or more, then steps of fourth order. With e = 1 − a y², 1/√a = y (1 −
/// e)^{−1/2} = y (1 + e/2 + 3/8 e² + 5/16 e³ + 35/128 e⁴ ...): one step leaves 0.3 e⁴, below 2⁻⁵³
/// if |e| < 2⁻¹³ as with the estimate of AVX-512; other sets take a step of second order after it.
template <class T>
Pack<T> inverse_sqrt(Pack<T> a) {
#if HWY_TARGET == HWY_SCALAR
  return Pack<T>(1) / sqrt(a);
#else
  static_assert(std::is_same_v<T, double>);
  using Tag = typename Pack<T>::Tag;
#if HWY_TARGET <= HWY_AVX3
  Pack<T> y(hn::Vec<Tag>{_mm512_rsqrt14_pd(a.v.raw)});
#else
  const hn::Rebind<float, Tag> narrow;
  Pack<T> y(hn::PromoteTo(Tag(), hn::ApproximateReciprocalSqrt(hn::DemoteTo(narrow, a.v))));
#endif
  Pack<T> e = Pack<T>(1.0) - a * y * y;
  y += y * (e * (Pack<T>(0.5) + e * (Pack<T>(0.375) + e * Pack<T>(0.3125))));
#if HWY_TARGET > HWY_AVX3
  e = Pack<T>(1.0) - a * y * y;
  y += y * (e * Pack<T>(0.5));
#endif
  return y;
#endif
}
/// The sum of all lanes.
template <class T>
T sum(Pack<T> a) {
  return hn::GetLane(hn::SumOfLanes(typename Pack<T>::Tag(), a.v));
}

/// Transposes a square: `row[i]` points to as many numbers as a pack is wide, and `column[k]`
/// becomes the k-th of each row. Loads and shuffles, where a gather would fetch numbers one by one.
template <class T>
void load_transposed(const T* const* row, Pack<T>* column) {
  static_assert(sizeof(T) == 8);
  const typename Pack<T>::Tag tag;
  const auto load = [&](std::size_t i) { return hn::LoadU(tag, row[i]); };
#if HWY_TARGET == HWY_SCALAR
  column[0] = Pack<T>(load(0));
#else
  // Within blocks of two numbers first, pairs of rows; then blocks change places.
  const auto pairs = [&](std::size_t i, std::size_t k) {
    return k == 0 ? hn::InterleaveLower(tag, load(i), load(i + 1))
                  : hn::InterleaveUpper(tag, load(i), load(i + 1));
  };
  for (std::size_t k = 0; k < 2; ++k) {
    if constexpr (Pack<T>::width == 2) {
      column[k] = Pack<T>(pairs(0, k));
    } else if constexpr (Pack<T>::width == 4) {
      const auto low = pairs(0, k), high = pairs(2, k);
      column[k] = Pack<T>(hn::ConcatLowerLower(tag, high, low));
      column[k + 2] = Pack<T>(hn::ConcatUpperUpper(tag, high, low));
    } else {
      static_assert(Pack<T>::width == 8);
      const auto a = pairs(0, k), b = pairs(2, k), c = pairs(4, k), d = pairs(6, k);
      const auto even = [](auto x, auto y) {  // blocks 0 and 2 of x and y in turn
        return hn::OddEvenBlocks(hn::SwapAdjacentBlocks(y), x);
      };
      const auto odd = [](auto x, auto y) {
        return hn::OddEvenBlocks(y, hn::SwapAdjacentBlocks(x));
      };
      column[k] = Pack<T>(hn::ConcatLowerLower(tag, even(c, d), even(a, b)));
      column[k + 2] = Pack<T>(hn::ConcatLowerLower(tag, odd(c, d), odd(a, b)));
      column[k + 4] = Pack<T>(hn::ConcatUpperUpper(tag, even(c, d), even(a, b)));
      column[k + 6] = Pack<T>(hn::ConcatUpperUpper(tag, odd(c, d), odd(a, b)));
    }
  }
#endif
}

}  // namespace HWY_NAMESPACE

template <class T>
struct MaskOf<Pack<T>> {
  using type = PackMask<T>;
};

}  // namespace polhode
