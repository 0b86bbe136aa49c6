// SPDX-License-Identifier: MIT
// The kinds of atoms that a file names, each stored once.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "polhode/io/coordinates/frame.hpp"

namespace polhode {

class AtomKinds {
 public:
  /// Begins a frame.
  explicit AtomKinds(std::vector<AtomKind>& kinds) : kinds_(kinds) { kinds_.clear(); }

  /// The index of the kind with this text; make() creates the kind at the first occurrence of the
  /// text.
  template <class Make>
  std::uint32_t of(std::string_view text, const Make& make) {
    if (const auto known = known_.find(text); known != known_.end()) return known->second;
    kinds_.push_back(make());
    const auto index = static_cast<std::uint32_t>(kinds_.size() - 1);
    known_.emplace(text, index);
    return index;
  }

 private:
  struct Hash : std::hash<std::string_view> {
    using is_transparent = void;
  };
  std::vector<AtomKind>& kinds_;
  std::unordered_map<std::string, std::uint32_t, Hash, std::equal_to<>> known_;
};

}  // namespace polhode
