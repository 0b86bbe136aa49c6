// SPDX-License-Identifier: MIT
// CRC-64, by which checkpoints and the files of a run are recognized.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace polhode {

/// The CRC-64 of bytes that follow others with the checksum `before`; 0 is that of no bytes. The
/// polynomial is that of ECMA-182, with the rest as in the XZ format: "123456789" gives
/// 0x995dc9bbdf1939fa.
std::uint64_t crc64(const void* bytes, std::size_t count, std::uint64_t before = 0);

/// The same for the bytes of a file from one offset to another.
/// @throws Error  if it cannot be read, or is shorter than that
std::uint64_t file_crc64(const std::string& path, std::uint64_t from, std::uint64_t to,
                         std::uint64_t before = 0);

/// Refuses a file if the checksum of its bytes from one offset to another is not what it was when a
/// checkpoint was written.
/// @throws Error  also if the file is missing or shorter
void check_crc64(const std::string& path, std::uint64_t from, std::uint64_t to,
                 std::uint64_t expected);

/// The text of that error, for formats that are not checked byte by byte.
std::string not_the_file(const std::string& path);

}  // namespace polhode
