// SPDX-License-Identifier: MIT
// The long box of OrthoBoXY from a cubic box.
#pragma once

#include "polhode/run/simulation/system/system.hpp"

namespace polhode {

/// The number of copies in the long box.
inline constexpr std::size_t elongated_copies = 3;

/// Stacks copies of a system along z, and scales them to the shape of the long box at the same
/// density.
void elongate(System& system);

}  // namespace polhode
