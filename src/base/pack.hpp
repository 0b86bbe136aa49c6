// SPDX-License-Identifier: MIT
// A pack is a SIMD vector of as many numbers as the instruction set processes at once. A pack has
// the interface of a single Real. Only this file uses the vector types of the SIMD library. Only
// files in `kernels` folders include this file. These files are compiled once per instruction set,
// with separate compiler flags.
#pragma once

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "polhode/base/quaternion.hpp"
#include "polhode/base/real.hpp"
#include "polhode/base/vec3.hpp"

namespace polhode {
inline namespace HWY_NAMESPACE {  // packs of different instruction sets are different types

namespace hn = hwy::HWY_NAMESPACE;

/// The widest pack of doubles or floats of this instruction set.
template <class T>
struct Pack {
  using value_type = T;
  using Tag = hn::ScalableTag<T>;
  using IndexTag = hn::RebindToSigned<Tag>;
  using Index = hn::Vec<IndexTag>;
  static constexpr std::size_t width = HWY_LANES(T);

  hn::Vec<Tag> v;

  Pack() : v(hn::Zero(Tag())) {}
  Pack(T value) : v(hn::Set(Tag(), value)) {}  // implicit, so that a literal can serve as a Real
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

/// The result of a comparison, lane by lane.
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
/// A mask that selects the first `count` lanes.
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
/// The smaller and the larger of two numbers, lane by lane.
template <class T>
Pack<T> min(Pack<T> a, Pack<T> b) {
  return Pack<T>(hn::Min(a.v, b.v));
}
template <class T>
Pack<T> max(Pack<T> a, Pack<T> b) {
  return Pack<T>(hn::Max(a.v, b.v));
}
/// Multiply-add a b + c, with a single rounding if the hardware supports it.
template <class T>
Pack<T> fma(Pack<T> a, Pack<T> b, Pack<T> c) {
  return Pack<T>(hn::MulAdd(a.v, b.v, c.v));
}
/// The sum of all lanes.
template <class T>
T sum(Pack<T> a) {
  return hn::GetLane(hn::SumOfLanes(typename Pack<T>::Tag(), a.v));
}

}  // namespace HWY_NAMESPACE

template <class T>
struct MaskOf<Pack<T>> {
  using type = PackMask<T>;
};

/// Negative powers of a distance r, computed from a = r². The hardware gives an estimate y of 1/√a.
/// With e = 1 − a y², 1/rⁿ = yⁿ (1 − e)^{−n/2} is a short series in e. The series is truncated
/// where the next term is below half a unit in the last place. |e| is below 2⁻¹³ for AVX-512
/// (14-bit estimates), below 2⁻¹⁰ for 12-bit estimates, and below 2⁻⁷ for NEON (8-bit estimates).
/// In double precision, and for 8-bit estimates, a second-order step first reduces e to ¾ e². Lane
/// types: float, double. Largest errors of 1/r, 1/r² and 1/r³: 1.25, 2.75 and 3.5 ULP; in scalar
/// packs 1, 2.5 and 4 ULP (tests/unit/base/pack_test.cpp). Valid range: any a that is a normal
/// float.
template <class T>
class InversePowers<Pack<T>> {
 public:
  using Real = Pack<T>;
  InversePowers() = default;
  explicit InversePowers(Real a) : y_(estimate(a)), y2_(y_ * y_), e_(Real(1) - a * y2_) {
    if constexpr (needs_step) {
      y_ += y_ * (e_ * Real(0.5));
      y2_ = y_ * y_;
      e_ = Real(1) - a * y2_;
    }
  }
  /// 1/r
  Real first() const { return y_ + correction(1. / 2, 3. / 8, 5. / 16); }
  /// 1/r²
  Real second() const { return y_ * (y_ + correction(1, 1, 1)); }
  /// 1/r³
  Real third() const { return y2_ * (y_ + correction(3. / 2, 15. / 8, 35. / 16)); }

 private:
#if HWY_TARGET == HWY_SCALAR
  static constexpr int estimate_bits = 53;
#elif HWY_TARGET <= HWY_AVX3
  static constexpr int estimate_bits = 14;
#elif HWY_TARGET == HWY_NEON
  static constexpr int estimate_bits = 8;
#else
  static constexpr int estimate_bits = 12;
#endif
  static constexpr bool needs_step = estimate_bits < (sizeof(T) == 8 ? 14 : 12);

  // The correction y (c1 e + c2 e² + c3 e³). Factors that several powers have in common are
  // computed once.
  Real correction(double c1, double c2, double c3) const {
    const auto c = [](double x) { return Real(static_cast<T>(x)); };
    const Real ye = y_ * e_;
    if constexpr (HWY_TARGET == HWY_SCALAR)  // NOLINT(misc-redundant-expression): macros
      return Real();
    else if constexpr (sizeof(T) == 8)
      return ye * fma(e_, fma(e_, c(c3), c(c2)), c(c1));
    else if constexpr (estimate_bits == 14 || needs_step)
      return ye * c(c1);
    else
      return ye * fma(e_, c(c2), c(c1));
  }
  static Real estimate(Real a) {
    [[maybe_unused]] const typename Real::Tag tag;
#if HWY_TARGET == HWY_SCALAR
    return Real(1) / sqrt(a);
#elif HWY_TARGET <= HWY_AVX3
    if constexpr (sizeof(T) == 8)
      return Real(decltype(a.v){_mm512_rsqrt14_pd(a.v.raw)});
    else
      return Real(decltype(a.v){_mm512_rsqrt14_ps(a.v.raw)});
#else
    if constexpr (sizeof(T) == 8) {
      const hn::Rebind<float, typename Real::Tag> narrow;
      return Real(hn::PromoteTo(tag, hn::ApproximateReciprocalSqrt(hn::DemoteTo(narrow, a.v))));
    } else {
      return Real(hn::ApproximateReciprocalSqrt(a.v));
    }
#endif
  }
  Real y_, y2_, e_;
};

/// The inverse square root 1/√a, with accuracy and range as for InversePowers.
template <class T>
Pack<T> inverse_sqrt(Pack<T> a) {
  return InversePowers<Pack<T>>(a).first();
}

}  // namespace polhode
