// SPDX-License-Identifier: MIT
// Counter-based random numbers (Philox 4x32-10, salmon2011). The n-th number of a stream is a
// function of seed, stream and n, so streams never overlap and every result is reproducible.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "polhode/base/quaternion.hpp"
#include "polhode/base/units.hpp"

namespace polhode {

constexpr std::uint64_t full_product(std::uint32_t a, std::uint32_t b) {
  return std::uint64_t{a} * b;
}
constexpr std::uint32_t upper_half(std::uint64_t x) { return static_cast<std::uint32_t>(x >> 32); }
constexpr std::uint32_t lower_half(std::uint64_t x) { return static_cast<std::uint32_t>(x); }

/// Ten rounds of the Philox generator, which maps 128-bit counters one-to-one for every 64-bit key.
/// @tparam Word  word of 32 bits, or a pack of such words (WordPack)
template <class Word = std::uint32_t>
constexpr std::array<Word, 4> philox(std::array<Word, 4> counter,
                                     std::array<std::uint32_t, 2> key) {
  for (int round = 0; round < 10; ++round) {
    const auto a = full_product(counter[0], 0xD2511F53), b = full_product(counter[2], 0xCD9E8D57);
    counter = {upper_half(b) ^ counter[1] ^ key[0], lower_half(b),
               upper_half(a) ^ counter[3] ^ key[1], lower_half(a)};
    key = {key[0] + 0x9E3779B9, key[1] + 0xBB67AE85};  // constants from the golden ratio and √3 − 1
  }
  return counter;
}

/// Derives the seed of the `index`-th item of a series from a common seed, for example for initial
/// configurations of a study. The derived seed is half of a Philox block. No Random object uses the
/// counter of this block. Two derived seeds are equal with probability 2⁻⁶⁴. If seed and index were
/// simply added, index 1 of seed 1 would equal index 0 of seed 2.
constexpr std::uint64_t derived_seed(std::uint64_t seed, std::uint64_t index) {
  const auto word = [](std::uint64_t x) { return static_cast<std::uint32_t>(x); };
  const auto block =
      philox({word(index), word(index >> 32), ~0u, ~0u}, {word(seed), word(seed >> 32)});
  return std::uint64_t{block[0]} << 32 | block[1];
}

/// One stream of random numbers.
class Random {
 public:
  explicit Random(std::uint64_t seed, std::uint64_t stream = 0) : seed_(seed), stream_(stream) {}

  /// Returns 64 random bits.
  std::uint64_t bits() {
    const bool second = count_ % 2 == 1;
    if (!second) {
      const std::uint64_t n = count_ / 2;
      block_ = philox({word(n), word(n >> 32), word(stream_), word(stream_ >> 32)},
                      {word(seed_), word(seed_ >> 32)});
    }
    ++count_;
    const std::size_t k = second ? 2 : 0;
    return std::uint64_t{block_[k]} << 32 | block_[k + 1];
  }

  /// A uniform number in the open interval (0, 1), at the midpoint of one of 2⁵² equal intervals.
  double uniform() { return (static_cast<double>(bits() >> 12) + 0.5) * 0x1p-52; }

  /// A random integer below n; each probability deviates from 1/n by a relative error of at most
  /// n/2⁶⁴.
  std::uint64_t below(std::uint64_t n) { return bits() % n; }

  /// A normal deviate with mean 0 and variance 1, by the Box-Muller method; the second number of
  /// each pair is discarded.
  double normal() {
    const double r = std::sqrt(-2 * std::log(uniform()));
    return r * std::cos(2 * units::pi * uniform());
  }

  /// A uniformly distributed orientation, obtained from a normal 4-vector, which has no preferred
  /// direction.
  Quaternion<double> orientation() {
    const double w = normal(), x = normal(), y = normal(), z = normal();
    return normalized(Quaternion<double>{w, x, y, z});
  }

 private:
  static constexpr std::uint32_t word(std::uint64_t x) { return static_cast<std::uint32_t>(x); }

  std::uint64_t seed_, stream_, count_ = 0;
  std::array<std::uint32_t, 4> block_{};
};

}  // namespace polhode
