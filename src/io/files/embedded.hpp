// SPDX-License-Identifier: MIT
// Data files that are built into the program; their paths are relative to data/.
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace polhode {

struct EmbeddedFile {
  std::string_view path;  ///< path such as "molecules/tip4p.toml"
  std::string_view text;
};

std::span<const EmbeddedFile> embedded_files();

/// The text of the embedded file with a given path; empty if there is none.
std::optional<std::string_view> embedded_text(std::string_view path);

}  // namespace polhode
