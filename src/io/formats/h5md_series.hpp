// SPDX-License-Identifier: MIT
// The values for each frame of an H5MD file, as this program writes them.
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

/// A series with a value at each frame: its dataset, and the dimensions of one row.
struct Series {
  hdf5::Handle values;
  std::vector<hsize_t> row;
};

/// The path of the values of a series. The series `step` and `time` are datasets. All other series
/// are groups with the datasets step, time and value.
std::string value_path(const std::string& name);

/// The names of the objects within a group.
std::vector<std::string> links(hid_t group);

/// All series of a file, by their names.
std::map<std::string, Series> series_of(hid_t file);

/// The hyperslab of one row in the file.
hdf5::Handle row_space(const Series& series, std::uint64_t frame);

/// The CRC-64 of the rows of all series for a frame, in the byte order of the file. The checksum
/// continues the checksum of the previous frames. The result is empty if rows cannot be read.
std::optional<std::uint64_t> frame_checksum(const std::map<std::string, Series>& all,
                                            std::uint64_t frame, std::uint64_t before);

}  // namespace polhode::h5md
