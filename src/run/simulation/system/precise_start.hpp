// SPDX-License-Identifier: MIT
// The state of an initial configuration at full precision, from a checkpoint.
#pragma once

#include <string>

#include "polhode/run/simulation/system/system.hpp"

namespace polhode {

/// Replaces the state of a system, which has the digits of a coordinate file, by that of a
/// checkpoint of the same molecules; the time remains.
/// @param path  of the checkpoint of a run or of a preparation
/// @throws Error  if the file is damaged or of another version, or if a box edge or a site differs
///                by more than the digits of common formats, 0.002 nm
void take_checkpoint(System& system, const std::string& path);

}  // namespace polhode
