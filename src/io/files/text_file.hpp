// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

namespace polhode {

/// Whether a regular file exists. The result is also false for a name that the operating system
/// rejects, for example a name that is too long.
bool is_file(const std::string& path);

/// The contents of a file. Throws an Error with the name of the file.
std::string file_text(const std::string& path);

/// The contents of a stream.
/// @param expected  expected length, for which memory is reserved; 0 if unknown
std::string stream_text(std::istream& in, const std::string& file, std::size_t expected = 0);

/// Opens a file for reading. Throws an Error with the name of the file.
std::ifstream open_text_file(const std::string& path);

/// A message about the first byte that cannot occur in a text file; empty if there is no such byte.
std::optional<std::string> odd_byte(std::string_view text, const std::string& file);

}  // namespace polhode
