// SPDX-License-Identifier: MIT
#include "text_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "polhode/base/error.hpp"

namespace polhode {
namespace {

bool is_odd(unsigned char c) {
  return (c < ' ' && c != '\t' && c != '\n' && c != '\r' && c != '\f') || c == 0x7f;
}

Error unreadable(const std::string& path) {
  return Error(fmt::format("there is no readable file '{}'; check its path", path));
}

}  // namespace

std::ifstream opened(const std::string& path) {
  std::error_code unknown;
  if (std::filesystem::is_directory(path, unknown))
    throw Error(fmt::format("'{}' is a folder; name a file in it", path));
  std::ifstream file(path, std::ios::binary);
  if (!file) throw unreadable(path);
  return file;
}

std::optional<std::string> odd_byte(std::string_view text, const std::string& file) {
  const auto odd = std::find_if(text.begin(), text.end(), is_odd);
  if (odd == text.end()) return std::nullopt;
  return fmt::format("'{}' holds the byte 0x{:02x}, which no text does; name a text file", file,
                     static_cast<unsigned char>(*odd));
}

std::string file_text(const std::string& path) {
  std::ifstream file = opened(path);
  std::string read;
  constexpr std::size_t piece = 1 << 16;
  std::error_code unknown;
  if (const auto size = std::filesystem::file_size(path, unknown); !unknown)
    read.reserve(size + piece);  // what has no size, a pipe, grows
  while (file) {
    const std::size_t before = read.size();
    read.resize(before + piece);
    file.read(read.data() + before, piece);
    read.resize(before + static_cast<std::size_t>(file.gcount()));
  }
  if (!file.eof() || file.bad()) throw unreadable(path);
  if (const auto what = odd_byte(read, path)) {
    const auto odd = std::find_if(read.begin(), read.end(), is_odd);
    throw Error(*what, fmt::format("{}:{}", path, 1 + std::count(read.begin(), odd, '\n')));
  }
  return read;
}

}  // namespace polhode
