// SPDX-License-Identifier: MIT
// Runs: eight consecutive numbers in a row of a grid, at any address, in one vector or as many as
// necessary; and grid positions for packs of points.
#pragma once

#include <algorithm>

#include "polhode/base/pack_integers.hpp"

namespace polhode {
inline namespace HWY_NAMESPACE {

/// Eight consecutive numbers.
template <class T>
struct Run {
  using Tag = hn::CappedTag<T, 8>;
  static constexpr std::size_t length = 8, width = std::min<std::size_t>(length, HWY_LANES(T));
  static constexpr std::size_t parts = length / width;

  hn::Vec<Tag> v[parts];

  static Run zero() { return all(0); }
  static Run all(T value) {
    Run run;
    for (auto& part : run.v) part = hn::Set(Tag(), value);
    return run;
  }
  static Run load(const T* p) {
    Run run;
    for (std::size_t k = 0; k < parts; ++k) run.v[k] = hn::LoadU(Tag(), p + k * width);
    return run;
  }
  void store(T* p) const {
    for (std::size_t k = 0; k < parts; ++k) hn::StoreU(v[k], Tag(), p + k * width);
  }
  friend Run operator*(const Run& a, const Run& b) {
    Run run;
    for (std::size_t k = 0; k < parts; ++k) run.v[k] = hn::Mul(a.v[k], b.v[k]);
    return run;
  }
  /// a b + c
  friend Run fma(const Run& a, const Run& b, const Run& c) {
    Run run;
    for (std::size_t k = 0; k < parts; ++k) run.v[k] = hn::MulAdd(a.v[k], b.v[k], c.v[k]);
    return run;
  }
};

/// Two runs, in one vector if it is wide enough.
template <class T>
struct RunPair {
  static constexpr bool single_vector = HWY_LANES(T) == 2 * Run<T>::length;
  using Tag = hn::ScalableTag<T>;
  struct TwoVectors {
    Run<T> first, second;
  };

  std::conditional_t<single_vector, hn::Vec<Tag>, TwoVectors> v;

  /// The first number in all elements of the first run, the second in those of the second.
  static RunPair all(T first, T second) { return join(Run<T>::all(first), Run<T>::all(second)); }
  /// The same eight numbers in both runs.
  static RunPair twice(const T* p) {
    const Run<T> run = Run<T>::load(p);
    return join(run, run);
  }
  Run<T> first() const {
    if constexpr (single_vector)
      return {{hn::LowerHalf(typename Run<T>::Tag(), v)}};
    else
      return v.first;
  }
  Run<T> second() const {
#if HWY_TARGET != HWY_SCALAR
    if constexpr (single_vector) return {{hn::UpperHalf(typename Run<T>::Tag(), v)}};
#endif
    if constexpr (!single_vector) return v.second;
  }
  /// Stores both runs, one after the other.
  void store(T* p) const {
    if constexpr (single_vector)
      hn::StoreU(v, Tag(), p);
    else
      v.first.store(p), v.second.store(p + Run<T>::length);
  }
  friend RunPair operator*(const RunPair& a, const RunPair& b) {
    if constexpr (single_vector)
      return {hn::Mul(a.v, b.v)};
    else
      return {{a.v.first * b.v.first, a.v.second * b.v.second}};
  }
  /// a b + c
  friend RunPair fma(const RunPair& a, const RunPair& b, const RunPair& c) {
    if constexpr (single_vector)
      return {hn::MulAdd(a.v, b.v, c.v)};
    else
      return {{fma(a.v.first, b.v.first, c.v.first), fma(a.v.second, b.v.second, c.v.second)}};
  }

 private:
  static RunPair join(const Run<T>& first, const Run<T>& second) {
#if HWY_TARGET != HWY_SCALAR
    if constexpr (single_vector) return {hn::Combine(Tag(), second.v[0], first.v[0])};
#endif
    if constexpr (!single_vector) return {{first, second}};
  }
};

/// Position of points on a grid with `points` points per edge: the index of the grid point below
/// each and, as the result, the distance beyond it, from 0 to 1 up to rounding. A point is the sum
/// of a centre and an arm [nm], in any periodic image.
inline Pack<double> grid_position(Pack<double> centre, Pack<double> arm, std::int32_t points,
                                  double edge, std::int32_t* index) {
  const Pack<double> n(points);
  Pack<double> t = (centre + arm) * Pack<double>(points / edge);
  t -= n * Pack<double>(hn::Floor((t * Pack<double>(1.0 / points)).v));
  const Pack<double> before(hn::Floor(t.v));
  const Pack<double> wrapped =  // rounding may have given -1 or n
      select(before < n, select(before < Pack<double>(0), n - Pack<double>(1), before),
             Pack<double>(0));
  const hn::Rebind<std::int32_t, Pack<double>::Tag> narrow;
  hn::StoreU(hn::DemoteTo(narrow, wrapped.v), narrow, index);
  return t - before;
}

/// The same for a centre in fixed point, 2³⁰ units to an edge. The distance is exact to one
/// rounding, because the integer part is computed modulo 2³².
inline Pack<float> grid_position(Pack<float> centre, Pack<float> arm, std::int32_t points,
                                 double edge, std::int32_t* index) {
  const Pack<float>::Tag tag;
  const FixedTag fixed;
  constexpr std::int32_t unit = 1 << 30;
  const Pack<float> in_units = arm * Pack<float>(static_cast<float>(unit / edge));
  const auto x = hn::And(hn::Add(hn::BitCast(fixed, centre.v), hn::NearestInt(in_units.v)),
                         hn::Set(fixed, unit - 1));
  const Pack<float> t =
      Pack<float>(hn::ConvertTo(tag, x)) * Pack<float>(static_cast<float>(points) * 0x1p-30f);
  const auto before = hn::ConvertTo(fixed, t.v);
  const auto n = hn::Set(fixed, points);
  const auto beyond = hn::Sub(hn::Mul(x, n), hn::ShiftLeft<30>(before));
  hn::StoreU(hn::IfThenElse(hn::Lt(before, n), before, hn::Zero(fixed)), fixed, index);
  return Pack<float>(hn::ConvertTo(tag, beyond)) * Pack<float>(0x1p-30f);
}

}  // namespace HWY_NAMESPACE
}  // namespace polhode
