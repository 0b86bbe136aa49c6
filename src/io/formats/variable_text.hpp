// SPDX-License-Identifier: MIT
// Strings of variable length in HDF5 files, which most programs use for units.
#pragma once

#include <hdf5.h>

#include <cstddef>
#include <string>
#include <vector>

namespace polhode::hdf5 {

inline constexpr std::size_t max_texts = 3;           // maximum number of texts in an attribute,
                                                      // one for each direction
inline constexpr std::size_t max_text_length = 1024;  // maximum length in bytes

/// The `count` strings of an attribute, at most `max_texts`. The result is empty if the strings
/// cannot be read. The strings are read in a separate process, because the HDF5 library (1.10)
/// trusts the lengths in the file. A damaged file can make the HDF5 library write out of bounds or
/// loop forever.
std::vector<std::string> variable_texts(hid_t attribute, hid_t type, std::size_t count);

}  // namespace polhode::hdf5
