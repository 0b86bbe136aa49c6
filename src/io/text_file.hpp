// SPDX-License-Identifier: MIT
#pragma once

#include <fstream>
#include <optional>
#include <string>
#include <string_view>

namespace polhode {

/// The whole text of a file, or an Error that names it.
std::string file_text(const std::string& path);

/// A file open for reading, or an Error that names it.
std::ifstream opened(const std::string& path);

/// What to say of the first byte that no text has, if there is one.
std::optional<std::string> odd_byte(std::string_view text, const std::string& file);

}  // namespace polhode
