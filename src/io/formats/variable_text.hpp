// SPDX-License-Identifier: MIT
// Strings of variable length in HDF5 files, which most programs write their units as.
#pragma once

#include <hdf5.h>

#include <cstddef>
#include <optional>
#include <string>

namespace polhode::hdf5 {

inline constexpr std::size_t most_texts = 3;       // of an attribute: one for each direction
inline constexpr std::size_t longest_text = 1024;  // bytes

/// The first of an attribute's strings, of which there are `most_texts` at most; nothing if they
/// cannot be read. A process of its own reads them: the library (1.10) trusts the lengths that a
/// file tells of such strings, and a damaged file has it write beyond its memory or loop forever.
std::optional<std::string> variable_text(hid_t attribute, hid_t type);

}  // namespace polhode::hdf5
