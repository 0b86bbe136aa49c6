// SPDX-License-Identifier: MIT
// A position in a text file.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

namespace polhode {

struct TextPlace {
  std::shared_ptr<const std::string> file;  ///< name of the file, stored once for all its lines
  std::size_t line = 0;                     ///< line number, starting at 1
};

/// A place as text: "topol.top:12".
std::string text_of(const TextPlace& place);

}  // namespace polhode
