// SPDX-License-Identifier: MIT
#include "io/files/embedded.hpp"

namespace polhode {

std::optional<std::string_view> embedded_text(std::string_view path) {
  for (const EmbeddedFile& file : embedded_files())
    if (file.path == path) return file.text;
  return std::nullopt;
}

}  // namespace polhode
