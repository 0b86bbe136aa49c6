// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

namespace polhode {

/// The whole text of a file, or an Error that names it.
std::string file_text(const std::string& path);

/// The same from a stream.
/// @param expected  length, where it is known: memory for so many bytes is taken at once
std::string stream_text(std::istream& in, const std::string& file, std::size_t expected = 0);

/// A file open for reading, or an Error that names it.
std::ifstream opened(const std::string& path);

/// What to say of the first byte that no text has, if there is one.
std::optional<std::string> odd_byte(std::string_view text, const std::string& file);

}  // namespace polhode
