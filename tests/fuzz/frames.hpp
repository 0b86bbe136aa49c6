// SPDX-License-Identifier: MIT
// Shared by the fuzz targets for trajectories.
#pragma once

#include <sstream>
#include <string>
#include <string_view>

#include "polhode/io/coordinates/frame_file.hpp"

namespace polhode::fuzz {

/// Reads all frames of a file with the given bytes.
inline void read_all_frames(std::string_view bytes, std::string_view format) {
  std::istringstream in{std::string(bytes)};
  const auto frames = read_frames(in, format, "fuzz." + std::string(format));
  Frame frame;
  while (frames->next(frame)) {
  }
}

}  // namespace polhode::fuzz
