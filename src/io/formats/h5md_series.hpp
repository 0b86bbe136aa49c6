// SPDX-License-Identifier: MIT
// The values at each frame of an H5MD file, as this program writes them.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "hdf5.hpp"

namespace polhode::h5md {

constexpr const char* step = "particles/all/step";
constexpr const char* time = "particles/all/time";

/// A value at each frame: the dataset that holds it, and the extents of one row.
struct Series {
  hdf5::Handle values;
  std::vector<hsize_t> row;
};

/// The dataset of a series: step and time are datasets themselves, all others have one beside
/// these.
std::string value_path(const std::string& name);

/// The names within a group.
std::vector<std::string> links(hid_t group);

/// All series of a file, by their names.
std::map<std::string, Series> series_of(hid_t file);

/// The place of one row in the file.
hdf5::Handle row_space(const Series& series, std::uint64_t frame);

/// CRC-64 of what all series hold of a frame, in the numbers of the file, after those of the frames
/// before; nothing if that cannot be read.
std::optional<std::uint64_t> frame_checksum(const std::map<std::string, Series>& all,
                                            std::uint64_t frame, std::uint64_t before);

}  // namespace polhode::h5md
