// SPDX-License-Identifier: MIT
// Data files that the program carries within itself, by their path below data/.
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace polhode {

struct EmbeddedFile {
  std::string_view path;  ///< "molecules/tip4p.toml"
  std::string_view text;
};

std::span<const EmbeddedFile> embedded_files();

/// The text of one embedded file, if there is one of that path.
std::optional<std::string_view> embedded_text(std::string_view path);

}  // namespace polhode
