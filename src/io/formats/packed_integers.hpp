// SPDX-License-Identifier: MIT
// Coordinates of XTC files: integers, packed into as few bits as their range needs. Consecutive
// atoms that are close to each other are stored as small differences. Each sequence of small
// differences states whether the next differences have a smaller or larger range. The encoding is
// defined by the XDR routine xdr3dcoord (F. van Hoesel), which all programs that read XTC files
// share.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace polhode {

using IntegerVector = std::array<std::int32_t, 3>;

struct PackedIntegers {
  IntegerVector lower{}, upper{};  ///< bounds of each coordinate
  std::int32_t small_range = 0;    ///< index of the range of the first differences
  std::vector<std::uint8_t> bits;  ///< packed bits, most significant first
};

/// Packs the coordinates of atoms.
PackedIntegers pack_integers(std::vector<IntegerVector> atoms);

/// Unpacks the coordinates of `count` atoms. Memory grows as atoms are read, so the memory is at
/// most 48 bytes per byte of `bits`.
/// @throws Error  if the bits end early or are inconsistent; the message names no file
std::vector<IntegerVector> unpack_integers(const IntegerVector& lower, const IntegerVector& upper,
                                           std::int32_t small_range,
                                           std::span<const std::uint8_t> bits, std::size_t count);

}  // namespace polhode
