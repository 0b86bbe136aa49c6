// SPDX-License-Identifier: MIT
// Strings of variable length in HDF5 files, which most programs write their units as.
#pragma once

#include <hdf5.h>

#include <cstddef>
#include <string>
#include <vector>

namespace polhode::hdf5 {

inline constexpr std::size_t max_texts = 3;           // of an attribute: one for each direction
inline constexpr std::size_t max_text_length = 1024;  // bytes

/// An attribute's strings, of which there are `count`, `max_texts` at most; none if they
/// cannot be read. A process of its own reads them: the library (1.10) trusts the lengths that a
/// file tells of such strings, and a damaged file has it write beyond its memory or loop forever.
std::vector<std::string> variable_texts(hid_t attribute, hid_t type, std::size_t count);

}  // namespace polhode::hdf5
