// SPDX-License-Identifier: MIT
// Packs of integers: indices, and coordinates in fixed point with exact differences.
#pragma once

#include <cstdint>

#include "base/pack_transpose.hpp"

namespace polhode {
inline namespace HWY_NAMESPACE {

using FixedTag = hn::RebindToSigned<Pack<float>::Tag>;

/// The difference p[k] − from, exact in 32 bits with wrap-around, then rounded to float.
inline Pack<float> fixed_point_difference(const std::int32_t* p, std::int32_t from) {
  const FixedTag fixed;
  return Pack<float>(
      hn::ConvertTo(Pack<float>::Tag(), hn::Sub(hn::LoadU(fixed, p), hn::Set(fixed, from))));
}

/// The difference of fixed-point integers held as the bits of a pack, exact in 32 bits with
/// wrap-around, then rounded to float.
inline Pack<float> fixed_point_difference(Pack<float> bits, std::int32_t from) {
  const FixedTag fixed;
  return Pack<float>(
      hn::ConvertTo(Pack<float>::Tag(), hn::Sub(hn::BitCast(fixed, bits.v), hn::Set(fixed, from))));
}

/// Converts packs of doubles to a pack of floats.
inline Pack<float> demote(const std::array<Pack<double>, halves>& a) {
  const Pack<float>::Tag tag;
#if HWY_TARGET == HWY_SCALAR
  return Pack<float>(hn::DemoteTo(tag, a[0].v));
#else
  const hn::Half<Pack<float>::Tag> half;
  return Pack<float>(hn::Combine(tag, hn::DemoteTo(half, a[1].v), hn::DemoteTo(half, a[0].v)));
#endif
}

/// Rounds doubles to fixed point, held as the bits of a pack.
inline Pack<float> demote_to_fixed_point(const std::array<Pack<double>, halves>& a) {
  const Pack<float>::Tag tag;
  const FixedTag fixed;
#if HWY_TARGET == HWY_SCALAR
  return Pack<float>(hn::BitCast(tag, hn::DemoteTo(fixed, hn::Round(a[0].v))));
#else
  const hn::Half<FixedTag> half;
  return Pack<float>(hn::BitCast(tag, hn::Combine(fixed, hn::DemoteTo(half, hn::Round(a[1].v)),
                                                  hn::DemoteTo(half, hn::Round(a[0].v)))));
#endif
}

/// 32-bit integers, one for each lane of a pack.
template <class T>
struct PackIndex {
  using Tag = hn::Rebind<std::int32_t, typename Pack<T>::Tag>;
  hn::Vec<Tag> v;

  static PackIndex load(const std::uint32_t* p) {
    return {hn::LoadU(Tag(), reinterpret_cast<const std::int32_t*>(p))};
  }
  void store(std::int32_t* p) const { hn::StoreU(v, Tag(), p); }
  friend PackIndex operator+(PackIndex a, PackIndex b) { return {hn::Add(a.v, b.v)}; }
  friend PackIndex operator-(PackIndex a, std::int32_t b) {
    return {hn::Sub(a.v, hn::Set(Tag(), b))};
  }
  friend PackIndex operator&(PackIndex a, std::uint32_t b) {
    return {hn::And(a.v, hn::Set(Tag(), static_cast<std::int32_t>(b)))};
  }
  friend PackIndex operator<<(PackIndex a, std::size_t bits) {
    return {hn::ShiftLeftSame(a.v, static_cast<int>(bits))};
  }
  /// Arithmetic shift, which preserves the sign.
  friend PackIndex operator>>(PackIndex a, std::size_t bits) {
    return {hn::ShiftRightSame(a.v, static_cast<int>(bits))};
  }
  /// Replaces the elements where `sign` is negative.
  PackIndex replaced_if_negative(PackIndex sign, PackIndex by) const {
    const auto negative = hn::BroadcastSignBit(sign.v);
    return {hn::Or(hn::And(negative, by.v), hn::AndNot(negative, v))};
  }
  /// Adds b to the negative elements.
  PackIndex wrap(std::int32_t b) const {
    return {hn::Add(v, hn::And(hn::BroadcastSignBit(v), hn::Set(Tag(), b)))};
  }
};

inline Pack<double> as_doubles(PackIndex<double> a) {
  return Pack<double>(hn::PromoteTo(Pack<double>::Tag(), a.v));
}

/// The sum of fixed-point numbers with wrap-around; the numbers of the pack are held as bits.
inline Pack<float> fixed_point_sum(Pack<float> bits, PackIndex<float> b) {
  return Pack<float>(
      hn::BitCast(Pack<float>::Tag(), hn::Add(hn::BitCast(FixedTag(), bits.v), b.v)));
}

/// Loads from[index[k]] into each lane k.
inline Pack<double> gather_lanes(const double* from, const std::uint32_t* index) {
  const Pack<double>::Tag tag;
#if HWY_TARGET == HWY_SCALAR
  return Pack<double>(hn::Load(tag, from + index[0]));
#else
  const hn::RebindToSigned<Pack<double>::Tag> wide;
  const hn::Rebind<std::int32_t, Pack<double>::Tag> narrow;
  const auto words = hn::LoadU(narrow, reinterpret_cast<const std::int32_t*>(index));
  return Pack<double>(hn::GatherIndex(tag, from, hn::PromoteTo(wide, words)));
#endif
}

}  // namespace HWY_NAMESPACE
}  // namespace polhode
