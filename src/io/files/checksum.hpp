// SPDX-License-Identifier: MIT
// CRC-64 checksums, which show whether checkpoints and the files of a run have changed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace polhode {

/// Computes the CRC-64 of a sequence of bytes piece by piece; `before` is the checksum of the
/// preceding bytes, or 0 at the beginning. The polynomial is from ECMA-182, and the other
/// conventions are from the XZ format: "123456789" gives 0x995dc9bbdf1939fa.
std::uint64_t crc64(const void* bytes, std::size_t count, std::uint64_t before = 0);

/// The CRC-64 of the bytes of a file from one offset to another.
/// @throws Error  if the file cannot be read, or is shorter than the second offset
std::uint64_t file_crc64(const std::string& path, std::uint64_t from, std::uint64_t to,
                         std::uint64_t before = 0);

/// Rejects a file if the checksum of its bytes from one offset to another has changed since a
/// checkpoint was written.
/// @throws Error  also if the file is missing or shorter
void check_crc64(const std::string& path, std::uint64_t from, std::uint64_t to,
                 std::uint64_t expected);

/// The text of the error about a changed file, for formats that are not checked byte by byte.
std::string not_the_file(const std::string& path);

}  // namespace polhode
