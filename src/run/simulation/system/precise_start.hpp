// SPDX-License-Identifier: MIT
// The state of an initial configuration at full precision, from a checkpoint.
#pragma once

#include <string>

#include "polhode/run/simulation/system/system.hpp"

namespace polhode {

/// Replaces the state of a system by the state in a checkpoint of the same molecules. The state
/// that is replaced was read from a coordinate file, which has fewer digits. The time of the system
/// does not change.
/// @param path  path of the checkpoint of a run or preparation
/// @throws Error  if the file is damaged or of another version, or if a box edge or a site differs
///   by more than the rounding in common formats, 0.002 nm
void take_checkpoint(System& system, const std::string& path);

}  // namespace polhode
