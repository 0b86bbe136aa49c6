// SPDX-License-Identifier: MIT
// Stacks of copies of a system, such as the long box of OrthoBoXY from a cubic box.
#pragma once

#include "polhode/run/simulation/system/system.hpp"

namespace polhode {

/// Stacks copies of a system along z.
void stack(System& system, std::size_t copies);

/// The number of copies in the long box.
inline constexpr std::size_t elongated_copies = 3;

/// Stacks copies of a system along z, and scales them to the shape of the long box at the same
/// density.
void elongate(System& system);

}  // namespace polhode
