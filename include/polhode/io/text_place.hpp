// SPDX-License-Identifier: MIT
// Where in a text something stands.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

namespace polhode {

struct TextPlace {
  std::shared_ptr<const std::string> file;  ///< its name, kept once for all its lines
  std::size_t line = 0;                     ///< from 1
};

/// "topol.top:12".
std::string text_of(const TextPlace& place);

}  // namespace polhode
