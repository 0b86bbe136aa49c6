// SPDX-License-Identifier: MIT
// Stores the lanes of packs that a mask selects, without gaps.
#pragma once

#include <bit>

#include "base/pack_integers.hpp"

namespace polhode {
inline namespace HWY_NAMESPACE {

#if HWY_TARGET == HWY_AVX2  // AVX2 has no compress instruction, so a table lookup and a shuffle
                            // replace it

/// For each mask of eight lanes, the indices of the selected lanes in order, followed by zeros.
struct SelectedLanes {
  std::uint8_t of[256][8] = {};
  constexpr SelectedLanes() {
    for (unsigned mask = 0; mask < 256; ++mask)
      for (unsigned lane = 0, n = 0; lane < 8; ++lane)
        if (mask >> lane & 1) of[mask][n++] = static_cast<std::uint8_t>(lane);
  }
};
static constexpr SelectedLanes
    selected_lanes{};  // a member of each object, because it depends on the instruction set

/// In packs of 32-bit numbers, moves the lanes that a mask selects to the front.
class Compression {
  using Tag = Pack<float>::Tag;
  using WordTag = hn::RebindToUnsigned<Tag>;

 public:
  explicit Compression(PackMask<float> mask)
      : bits_(static_cast<unsigned>(_mm256_movemask_ps(hn::VecFromMask(Tag(), mask.m).raw))),
        lanes_(hn::PromoteTo(
            WordTag(), hn::LoadU(hn::Rebind<std::uint8_t, WordTag>(), selected_lanes.of[bits_]))) {}
  std::size_t count() const { return static_cast<std::size_t>(std::popcount(bits_)); }
  template <class AnyTag>
  hn::Vec<AnyTag> operator()(AnyTag tag, hn::Vec<AnyTag> from) const {
    return hn::TableLookupLanes(from, hn::IndicesFromVec(tag, lanes_));
  }

 private:
  unsigned bits_;
  hn::Vec<WordTag> lanes_;
};

#else

/// In packs of 32-bit numbers, moves the lanes that a mask selects to the front.
class Compression {
  using Tag = Pack<float>::Tag;

 public:
  explicit Compression(PackMask<float> mask) : mask_(mask.m) {}
  std::size_t count() const { return hn::CountTrue(Tag(), mask_); }
  template <class AnyTag>
  hn::Vec<AnyTag> operator()(AnyTag tag, hn::Vec<AnyTag> from) const {
    return hn::Compress(from, hn::RebindMask(tag, mask_));
  }

 private:
  hn::Mask<Tag> mask_;
};

#endif

/// Selected lanes of packs of floats, given by a mask.
class Selection {
 public:
  explicit Selection(PackMask<float> mask) : compression_(mask) {}

  /// The number of selected lanes.
  std::size_t count() const { return compression_.count(); }
  /// Stores the selected lanes consecutively. The memory after the selected lanes is overwritten,
  /// up to the width of a pack.
  void store(Pack<float> from, float* to) const {
    const Pack<float>::Tag tag;
    hn::StoreU(compression_(tag, from.v), tag, to);
  }
  void store(PackIndex<float> from, std::uint32_t* to) const {
    const hn::RebindToUnsigned<Pack<float>::Tag> words;
    hn::StoreU(compression_(words, hn::BitCast(words, from.v)), words, to);
  }

 private:
  Compression compression_;
};

/// A pack with the numbers 0, 1, 2, ... in its lanes.
inline Pack<float> lane_numbers() { return Pack<float>(hn::Iota(Pack<float>::Tag(), 0)); }

/// A pack with the numbers `first`, first + step, first + 2 step, ... in its lanes.
inline PackIndex<float> consecutive(std::uint32_t first, std::uint32_t step = 1) {
  const PackIndex<float>::Tag tag;
  const auto set = [&](std::uint32_t n) { return hn::Set(tag, static_cast<std::int32_t>(n)); };
  return {hn::Add(hn::Mul(hn::Iota(tag, 0), set(step)), set(first))};
}

}  // namespace HWY_NAMESPACE
}  // namespace polhode
