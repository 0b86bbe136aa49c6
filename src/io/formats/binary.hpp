// SPDX-License-Identifier: MIT
// Binary coordinate files: numbers in either byte order, and frames of atoms without names.
#pragma once

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <istream>
#include <ostream>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "polhode/base/error.hpp"
#include "polhode/io/coordinates/frame.hpp"

namespace polhode {

/// A number read from bytes in a given byte order.
template <class T>
T decode(const std::uint8_t* from, std::endian order) {
  std::array<std::uint8_t, sizeof(T)> bytes;
  std::copy_n(from, sizeof(T), bytes.begin());
  if (order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
  return std::bit_cast<T>(bytes);
}

/// Reads a file sequentially and keeps its position for error messages. The memory is allocated
/// while reading, so a wrong length in an untrusted header does not waste memory.
class BinaryInput {
 public:
  BinaryInput(std::istream& in, std::string file, std::endian order)
      : order(order), in_(in), file_(std::move(file)) {}

  const std::string& file() const { return file_; }
  bool at_end() { return in_.peek() == std::istream::traits_type::eof(); }

  template <class T>
  T take(const char* what) {
    return decode<T>(block(sizeof(T), what).data(), order);
  }
  /// The next bytes of the file, which are valid until the next call.
  std::span<const std::uint8_t> block(std::uint64_t bytes, const char* what) {
    constexpr std::uint64_t piece = 1 << 20;
    held_.clear();
    while (held_.size() < bytes) {
      const std::size_t before = held_.size();
      held_.resize(before + static_cast<std::size_t>(std::min(piece, bytes - before)));
      in_.read(reinterpret_cast<char*>(held_.data() + before),
               static_cast<std::streamsize>(held_.size() - before));
      const auto found = static_cast<std::uint64_t>(in_.gcount());
      if (before + found < held_.size())
        refuse(fmt::format("the file ends after {} of the {} bytes of {}; it is truncated",
                           before + found, bytes, what));
    }
    offset_ += bytes;
    return held_;
  }
  [[noreturn]] void refuse(const std::string& what) const {
    throw Error(what, fmt::format("{}, byte {}", file_, offset_));
  }

  std::endian order;

 private:
  std::istream& in_;
  std::string file_;
  std::uint64_t offset_ = 0;
  std::vector<std::uint8_t> held_;
};

/// Begins a frame of atoms of a single unnamed kind. The positions of the atoms are filled in
/// later.
inline void begin_unnamed(Frame& frame, const std::string& file) {
  frame.source = file;
  frame.title.clear();
  frame.kinds.assign(1, {});
  frame.atoms.clear();
  frame.has_velocities = false;
}

/// Returns a position. Throws an Error if a coordinate is not finite.
inline const Vec3<double>& finite(const Vec3<double>& r, const BinaryInput& in) {
  if (!std::isfinite(r.x) || !std::isfinite(r.y) || !std::isfinite(r.z))
    in.refuse("a coordinate or velocity is not finite");
  return r;
}

/// Collects bytes to be written to a file.
class BinaryOutput {
 public:
  explicit BinaryOutput(std::endian order) : order_(order) {}

  template <class T>
  void put(T number) {
    auto bytes = std::bit_cast<std::array<std::uint8_t, sizeof(T)>>(number);
    if (order_ != std::endian::native) std::reverse(bytes.begin(), bytes.end());
    put(std::span<const std::uint8_t>(bytes));
  }
  void put(std::span<const std::uint8_t> bytes) {
    const std::size_t before = bytes_.size();
    bytes_.resize(before + bytes.size());
    std::copy(bytes.begin(), bytes.end(), bytes_.begin() + static_cast<std::ptrdiff_t>(before));
  }
  void text(std::string_view text, std::size_t width) {
    for (std::size_t k = 0; k < width; ++k)
      bytes_.push_back(k < text.size() ? static_cast<std::uint8_t>(text[k]) : std::uint8_t{' '});
  }
  void write(std::ostream& out) const {
    out.write(reinterpret_cast<const char*>(bytes_.data()),
              static_cast<std::streamsize>(bytes_.size()));
  }

 private:
  std::endian order_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace polhode
