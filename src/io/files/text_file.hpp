// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

namespace polhode {

/// The contents of a file; throws an Error that names it.
std::string file_text(const std::string& path);

/// The same from a stream.
/// @param expected  length, if known: that much memory is reserved at once
std::string stream_text(std::istream& in, const std::string& file, std::size_t expected = 0);

/// A file opened for reading; throws an Error that names it.
std::ifstream open_text_file(const std::string& path);

/// A message about the first byte that cannot occur in a text file, if there is one.
std::optional<std::string> odd_byte(std::string_view text, const std::string& file);

}  // namespace polhode
