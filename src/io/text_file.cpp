// SPDX-License-Identifier: MIT
#include "text_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "polhode/base/error.hpp"

namespace polhode {

std::string file_text(const std::string& path) {
  std::error_code unreadable;
  if (std::filesystem::is_directory(path, unreadable))
    throw Error(fmt::format("'{}' is a folder; name a file in it", path));
  std::ifstream file(path, std::ios::binary);
  std::string read;
  constexpr std::size_t piece = 1 << 16;
  if (const auto size = std::filesystem::file_size(path, unreadable); file && !unreadable)
    read.reserve(size + piece);  // what has no size, a pipe, grows
  while (file) {
    const std::size_t before = read.size();
    read.resize(before + piece);
    file.read(read.data() + before, piece);
    read.resize(before + static_cast<std::size_t>(file.gcount()));
  }
  if (!file.eof() || file.bad())
    throw Error(fmt::format("there is no readable file '{}'; check its path", path));
  const auto odd = std::find_if(read.begin(), read.end(), [](unsigned char c) {
    return (c < ' ' && c != '\t' && c != '\n' && c != '\r' && c != '\f') || c == 0x7f;
  });
  if (odd != read.end())
    throw Error(fmt::format("'{}' holds the byte 0x{:02x}, which no text does; name a text file",
                            path, static_cast<unsigned char>(*odd)),
                fmt::format("{}:{}", path, 1 + std::count(read.begin(), odd, '\n')));
  return read;
}

}  // namespace polhode
