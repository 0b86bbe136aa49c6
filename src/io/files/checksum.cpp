// SPDX-License-Identifier: MIT
#include "io/files/checksum.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <fstream>
#include <vector>

#include "base/output_error.hpp"
#include "io/files/disk.hpp"

namespace polhode {
namespace {

// The polynomial of ECMA-182 in reversed bit order, as in the XZ format.
constexpr std::uint64_t polynomial = 0xc96c5795d7870f42;

// table[k][b] is the contribution of a byte b that is followed by k bytes.
constexpr auto table = [] {
  std::array<std::array<std::uint64_t, 256>, 8> t{};
  for (std::uint64_t b = 0; b < 256; ++b) {
    t[0][b] = b;
    for (int bit = 0; bit < 8; ++bit) t[0][b] = (t[0][b] >> 1) ^ (t[0][b] & 1 ? polynomial : 0);
  }
  for (std::size_t k = 1; k < 8; ++k)
    for (std::size_t b = 0; b < 256; ++b) t[k][b] = t[0][t[k - 1][b] & 0xff] ^ (t[k - 1][b] >> 8);
  return t;
}();

}  // namespace

std::uint64_t crc64(const void* bytes, std::size_t count, std::uint64_t before) {
  const auto* at = static_cast<const unsigned char*>(bytes);
  std::uint64_t crc = ~before;
  if constexpr (std::endian::native == std::endian::little)  // eight bytes at once
    for (; count >= 8; count -= 8, at += 8) {
      std::uint64_t word;
      std::memcpy(&word, at, 8);
      word ^= crc;
      crc = 0;
      for (std::size_t k = 0; k < 8; ++k) crc ^= table[7 - k][(word >> (8 * k)) & 0xff];
    }
  for (; count > 0; --count, ++at) crc = table[0][(crc ^ *at) & 0xff] ^ (crc >> 8);
  return ~crc;
}

std::uint64_t file_crc64(const std::string& path, std::uint64_t from, std::uint64_t to,
                         std::uint64_t before) {
  check_length(path, to);
  std::ifstream file(path, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(from));
  std::vector<char> piece(1 << 20);
  while (from < to) {
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(piece.size(), to - from));
    if (!file.read(piece.data(), static_cast<std::streamsize>(count)))
      throw Error(fmt::format("'{}' cannot be read; check its permissions", path));
    before = crc64(piece.data(), count, before);
    from += count;
  }
  return before;
}

void check_crc64(const std::string& path, std::uint64_t from, std::uint64_t to,
                 std::uint64_t expected) {
  if (file_crc64(path, from, to) != expected) throw OutputError(not_the_file(path));
}

std::string not_the_file(const std::string& path) {
  return fmt::format(
      "'{}' was changed: its checksum differs from the checksum in the checkpoint, so the run "
      "cannot append to the file; restore the file, or start over",
      path);
}

}  // namespace polhode
