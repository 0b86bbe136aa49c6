// SPDX-License-Identifier: MIT
// Packs of 32-bit words, for random numbers of all lanes at once. Included as pack.hpp is.
#pragma once

#include "base/pack.hpp"

namespace polhode {
inline namespace HWY_NAMESPACE {

/// Words of 32 bits, one for each lane of a pack of doubles. The words are the lower halves of
/// 64-bit lanes, and the upper halves are arbitrary.
class WordPack {
 public:
  static constexpr std::size_t width = Pack<double>::width;

  WordPack() : v_(hn::Zero(Tag())) {}
  WordPack(std::uint32_t word) : v_(hn::Set(Tag(), word)) {}  // implicit, as for Pack
  static WordPack load(const std::uint64_t* p) { return WordPack(hn::Load(Tag(), p)); }
  /// The words converted to numbers.
  Pack<double> numbers() const {  // with the exponent of 2⁵², the lowest bit of a double is 1
    const auto bits =
        hn::Or(hn::And(v_, hn::Set(Tag(), 0xffffffff)), hn::Set(Tag(), 0x433ull << 52));
    return Pack<double>(hn::BitCast(Pack<double>::Tag(), bits)) - Pack<double>(0x1p52);
  }
  friend WordPack operator^(WordPack a, WordPack b) { return WordPack(hn::Xor(a.v_, b.v_)); }
  /// The products of 32-bit words and b; each 64-bit product fills a lane.
  friend WordPack full_product(WordPack a, std::uint32_t b) {
#if HWY_TARGET == HWY_SCALAR
    return WordPack(hn::Set(Tag(), (hn::GetLane(a.v_) & 0xffffffff) * b));
#else
    const hn::RepartitionToNarrow<Tag> halves;
    return WordPack(hn::MulEven(hn::BitCast(halves, a.v_), hn::Set(halves, b)));
#endif
  }
  friend WordPack upper_half(WordPack a) { return WordPack(hn::ShiftRight<32>(a.v_)); }
  friend WordPack lower_half(WordPack a) { return a; }

 private:
  using Tag = hn::ScalableTag<std::uint64_t>;
  explicit WordPack(hn::Vec<Tag> v) : v_(v) {}
  hn::Vec<Tag> v_;
};

}  // namespace HWY_NAMESPACE
}  // namespace polhode
