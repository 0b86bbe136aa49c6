// SPDX-License-Identifier: MIT
#include "packed_integers.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <limits>

#include "polhode/base/error.hpp"

namespace polhode {
namespace {

__extension__ using Wide = unsigned __int128;

// Ranges of small differences. Three integers below ranges[k] are packed into k bits, so ranges[k]
// is about 2^(k/3). The table is from the original program. clang-format off
constexpr std::array<std::int32_t, 73> ranges = {
    0,        0,        0,       0,       0,       0,       0,       0,       0,       8,
    10,       12,       16,      20,      25,      32,      40,      50,      64,      80,
    101,      128,      161,     203,     256,     322,     406,     512,     645,     812,
    1024,     1290,     1625,    2048,    2580,    3250,    4096,    5060,    6501,    8192,
    10321,    13003,    16384,   20642,   26007,   32768,   41285,   52015,   65536,   82570,
    104031,   131072,   165140,  208063,  262144,  330280,  416127,  524287,  660561,  832255,
    1048576,  1321122,  1664510, 2097152, 2642245, 3329021, 4194304, 5284491, 6658042, 8388607,
    10568983, 13316085, 16777216};
// clang-format on
constexpr std::int32_t first_range = 9;
constexpr auto last_range = static_cast<std::int32_t>(ranges.size()) - 1;
constexpr std::uint32_t largest_joint = 0xffffff;  // above this, coordinates are packed one by one
constexpr std::size_t max_run_length = 8;          // largest number of atoms stored as differences

std::int32_t range_of(std::int32_t index) { return ranges[static_cast<std::size_t>(index)]; }

// The packing of one full position, which consists of three numbers below `sizes`. The three
// numbers are packed jointly if the sizes are small enough.
struct Layout {
  std::array<std::uint32_t, 3> sizes;
  std::array<unsigned, 3> single_bits{};
  unsigned joint_bits = 0;  // number of bits if packed jointly; 0 if packed one by one

  Layout(const IntegerVector& lower, const IntegerVector& upper) {
    Wide all = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      sizes[k] = static_cast<std::uint32_t>(std::int64_t{upper[k]} - lower[k] + 1);
      single_bits[k] = static_cast<unsigned>(std::bit_width(sizes[k]));
      all *= sizes[k];
    }
    if (*std::max_element(sizes.begin(), sizes.end()) > largest_joint) return;
    while (all >> joint_bits) ++joint_bits;
  }
};

class BitOutput {
 public:
  void put(std::uint32_t number, unsigned bits) {
    held_ = held_ << bits | number;
    for (waiting_ += bits; waiting_ >= 8; waiting_ -= 8)
      bytes_.push_back(static_cast<std::uint8_t>(held_ >> (waiting_ - 8)));
  }
  // Combines three numbers into one, with the lowest byte first.
  void put(const std::array<std::uint32_t, 3>& numbers, const std::array<std::uint32_t, 3>& sizes,
           unsigned bits) {
    Wide joint = (Wide{numbers[0]} * sizes[1] + numbers[1]) * sizes[2] + numbers[2];
    for (; bits > 8; bits -= 8, joint >>= 8) put(static_cast<std::uint32_t>(joint & 0xff), 8);
    put(static_cast<std::uint32_t>(joint), bits);
  }
  std::vector<std::uint8_t> finish() {
    if (waiting_ > 0) put(0, 8 - waiting_);
    return std::move(bytes_);
  }

 private:
  std::vector<std::uint8_t> bytes_;
  std::uint64_t held_ = 0;
  unsigned waiting_ = 0;  // number of bits that are not in bytes_ yet
};

class BitInput {
 public:
  explicit BitInput(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  std::uint32_t take(unsigned bits) {
    for (; waiting_ < bits; waiting_ += 8) {
      if (next_ == bytes_.size())
        throw Error("the packed coordinates end before the last atom; the file is damaged");
      held_ = held_ << 8 | bytes_[next_++];
    }
    waiting_ -= bits;
    return static_cast<std::uint32_t>(held_ >> waiting_ & ((std::uint64_t{1} << bits) - 1));
  }
  std::array<std::uint32_t, 3> take(const std::array<std::uint32_t, 3>& sizes, unsigned bits) {
    if (bits <= 64) return parts(joint<std::uint64_t>(bits), sizes);
    return parts(joint<Wide>(bits), sizes);
  }

 private:
  template <class Number>
  Number joint(unsigned bits) {
    Number number = 0;
    unsigned shift = 0;
    for (; bits > 8; bits -= 8, shift += 8) number |= Number{take(8)} << shift;
    return number | Number{take(bits)} << shift;
  }
  template <class Number>
  static std::array<std::uint32_t, 3> parts(Number number,
                                            const std::array<std::uint32_t, 3>& sizes) {
    std::array<std::uint32_t, 3> parts;
    for (const std::size_t k : {2u, 1u}) {
      parts[k] = static_cast<std::uint32_t>(number % sizes[k]);
      number /= sizes[k];
    }
    parts[0] = static_cast<std::uint32_t>(number);
    return parts;
  }

  std::span<const std::uint8_t> bytes_;
  std::size_t next_ = 0;
  std::uint64_t held_ = 0;
  unsigned waiting_ = 0;  // number of bits that have not been read yet
};

bool within(const IntegerVector& a, const IntegerVector& b, std::int64_t bound) {
  for (std::size_t k = 0; k < 3; ++k)
    if (std::abs(std::int64_t{a[k]} - b[k]) >= bound) return false;
  return true;
}

std::int64_t distance2(const IntegerVector& a, const IntegerVector& b) {
  std::int64_t sum = 0;
  for (std::size_t k = 0; k < 3; ++k)
    sum += (std::int64_t{a[k]} - b[k]) * (std::int64_t{a[k]} - b[k]);
  return sum;
}

// Index of the first range that can store the smallest difference between consecutive atoms.
std::int32_t first_small_range(const std::vector<IntegerVector>& atoms) {
  std::int64_t lower = std::numeric_limits<std::int32_t>::max();
  for (std::size_t i = 1; i < atoms.size(); ++i) {
    std::int64_t step = 0;
    for (std::size_t k = 0; k < 3; ++k)
      step += std::abs(std::int64_t{atoms[i][k]} - atoms[i - 1][k]);
    lower = std::min(lower, step);
  }
  std::int32_t index = first_range;
  while (index < last_range && range_of(index) < lower) ++index;
  return index;
}

}  // namespace

PackedIntegers pack_integers(std::vector<IntegerVector> atoms) {
  PackedIntegers result;
  if (atoms.empty()) return result;
  result.lower = result.upper = atoms.front();
  for (const IntegerVector& atom : atoms)
    for (std::size_t k = 0; k < 3; ++k) {
      result.lower[k] = std::min(result.lower[k], atom[k]);
      result.upper[k] = std::max(result.upper[k], atom[k]);
    }
  const Layout layout(result.lower, result.upper);
  std::int32_t small = result.small_range = first_small_range(atoms);
  const std::int32_t largest = std::min(last_range, small + 8);
  const std::int32_t smallest = std::max(first_range, largest - 8);
  BitOutput bits;
  std::size_t last_run = max_run_length + 1;  // a value that no run has
  IntegerVector previous{};
  for (std::size_t i = 0; i < atoms.size();) {
    const std::int32_t half = range_of(small) / 2;
    int change = small > smallest ? -1 : 0;
    if (small < largest && i > 0 && within(atoms[i], previous, range_of(largest) / 2)) change = 1;
    bool near = i + 1 < atoms.size() && within(atoms[i], atoms[i + 1], half);
    // The second atom is stored first: in water both hydrogens are close to the oxygen.
    if (near) std::swap(atoms[i], atoms[i + 1]);
    if (!near && change < 0) change = 0;

    std::array<std::uint32_t, 3> full;
    for (std::size_t k = 0; k < 3; ++k)
      full[k] = static_cast<std::uint32_t>(std::int64_t{atoms[i][k]} - result.lower[k]);
    if (layout.joint_bits > 0)
      bits.put(full, layout.sizes, layout.joint_bits);
    else
      for (std::size_t k = 0; k < 3; ++k) bits.put(full[k], layout.single_bits[k]);
    previous = atoms[i++];

    std::array<std::array<std::uint32_t, 3>, max_run_length> differences;
    std::size_t run = 0;
    const std::int64_t smaller = small > first_range ? range_of(small - 1) / 2 : 0;
    while (near && run < max_run_length) {
      if (change < 0 && distance2(atoms[i], previous) >= smaller * smaller) change = 0;
      for (std::size_t k = 0; k < 3; ++k)
        differences[run][k] = static_cast<std::uint32_t>(atoms[i][k] - previous[k] + half);
      ++run;
      previous = atoms[i++];
      near = i < atoms.size() && within(atoms[i], previous, half);
    }
    if (run != last_run || change != 0) {
      bits.put(1, 1);
      bits.put(static_cast<std::uint32_t>(3 * static_cast<int>(run) + change + 1), 5);
    } else {
      bits.put(0, 1);
    }
    last_run = run;
    const auto size = static_cast<std::uint32_t>(range_of(small));
    for (std::size_t k = 0; k < run; ++k)
      bits.put(differences[k], {size, size, size}, static_cast<unsigned>(small));
    small += change;
  }
  result.bits = bits.finish();
  return result;
}

std::vector<IntegerVector> unpack_integers(const IntegerVector& lower, const IntegerVector& upper,
                                           std::int32_t small_range,
                                           std::span<const std::uint8_t> bytes, std::size_t count) {
  constexpr std::int64_t max_width = std::numeric_limits<std::int32_t>::max();
  for (std::size_t k = 0; k < 3; ++k)
    if (upper[k] < lower[k] || std::int64_t{upper[k]} - lower[k] >= max_width)
      throw Error(
          fmt::format("packed coordinates range from {} to {}; the maximum must be at least the "
                      "minimum, and their difference less than {}",
                      lower[k], upper[k], max_width));
  const auto check_range = [](std::int32_t index) {
    if (index < first_range || index > last_range)
      throw Error(
          fmt::format("the range of small differences has index {}; it must be from {} to {}",
                      index, first_range, last_range));
  };
  check_range(small_range);
  const Layout layout(lower, upper);
  BitInput bits(bytes);
  std::vector<IntegerVector> atoms;
  std::size_t run = 0;
  std::int32_t small = small_range;
  const auto shifted = [max_width](const IntegerVector& base,
                                   const std::array<std::uint32_t, 3>& by, std::int64_t less) {
    IntegerVector sum;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t number = base[k] + std::int64_t{by[k]} - less;
      sum[k] = static_cast<std::int32_t>(std::clamp<std::int64_t>(number, -max_width, max_width));
    }
    return sum;
  };
  while (atoms.size() < count) {
    std::array<std::uint32_t, 3> full;
    if (layout.joint_bits > 0)
      full = bits.take(layout.sizes, layout.joint_bits);
    else
      for (std::size_t k = 0; k < 3; ++k) full[k] = bits.take(layout.single_bits[k]);
    IntegerVector previous = shifted(lower, full, 0);
    int change = 0;
    if (bits.take(1) == 1) {
      const std::uint32_t code = bits.take(5);
      run = code / 3;
      change = static_cast<int>(code % 3) - 1;
    }
    if (run + 1 > count - atoms.size())
      throw Error("a run of packed coordinates extends beyond the last atom; the file is damaged");
    atoms.push_back(previous);
    const std::int32_t half = range_of(small) / 2;
    const auto size = static_cast<std::uint32_t>(range_of(small));
    for (std::size_t k = 0; k < run; ++k) {
      previous =
          shifted(previous, bits.take({size, size, size}, static_cast<unsigned>(small)), half);
      atoms.push_back(previous);
      if (k == 0) std::swap(atoms.back(), atoms[atoms.size() - 2]);
    }
    small += change;
    check_range(small);
  }
  return atoms;
}

}  // namespace polhode
