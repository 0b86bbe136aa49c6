// SPDX-License-Identifier: MIT
#include "text_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "io/files/disk.hpp"
#include "polhode/base/error.hpp"
#include "split_words.hpp"

namespace polhode {
namespace {

bool is_odd(unsigned char c) {
  return (c < ' ' && c != '\t' && c != '\n' && c != '\r' && c != '\f') || c == 0x7f;
}

Error unreadable(const std::string& path) {
  if (const int error = errno; error == EMFILE || error == ENFILE)
    return Error(
        fmt::format("'{}' cannot be read ({}); {}", path, std::strerror(error), remedy_of(error)));
  std::error_code unknown;
  if (std::filesystem::exists(path, unknown))
    return Error(fmt::format("'{}' exists but cannot be read; check its permissions", path));
  return Error(fmt::format("there is no readable file '{}'; check the path", path));
}

}  // namespace

bool is_file(const std::string& path) {
  std::error_code unknown;
  return std::filesystem::is_regular_file(path, unknown);
}

std::ifstream open_text_file(const std::string& path) {
  std::error_code unknown;
  if (std::filesystem::is_directory(path, unknown))
    throw Error(fmt::format("'{}' is a folder; give a file in this folder", path));
  std::ifstream file(path, std::ios::binary);
  if (!file) throw unreadable(path);
  return file;
}

std::optional<std::string> odd_byte(std::string_view text, const std::string& file) {
  const auto odd = std::find_if(text.begin(), text.end(), is_odd);
  if (odd == text.end()) return std::nullopt;
  return fmt::format("'{}' contains the byte 0x{:02x}, so it is not a text file; give a text file",
                     file, static_cast<unsigned char>(*odd));
}

std::string file_text(const std::string& path) {
  std::ifstream file = open_text_file(path);
  std::error_code unknown;
  const auto size = std::filesystem::file_size(path, unknown);
  return stream_text(file, path, unknown ? 0 : size);  // pipes have no size
}

std::string stream_text(std::istream& in, const std::string& file, std::size_t expected) {
  std::string read;
  constexpr std::size_t piece = 1 << 16;
  read.reserve(expected + piece);
  while (in) {
    const std::size_t before = read.size();
    read.resize(before + piece);
    in.read(read.data() + before, piece);
    read.resize(before + static_cast<std::size_t>(in.gcount()));
  }
  if (!in.eof() || in.bad()) throw unreadable(file);
  if (const auto what = odd_byte(read, file)) {
    const auto odd = std::find_if(read.begin(), read.end(), is_odd);
    throw Error(*what, fmt::format("{}:{}", file, 1 + std::count(read.begin(), odd, '\n')));
  }
  read.erase(0, read.size() - without_mark(read).size());
  return read;
}

}  // namespace polhode
