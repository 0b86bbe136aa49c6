// SPDX-License-Identifier: MIT
// A folder of its own for a test.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace polhode {

/// Goes away afterwards.
struct Folder {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() /
      ("polhode-test-" + std::to_string(reinterpret_cast<std::uintptr_t>(this)));
  Folder() { std::filesystem::create_directories(path); }
  ~Folder() { std::filesystem::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string operator/(const std::string& name) const { return (path / name).string(); }
};

}  // namespace polhode
