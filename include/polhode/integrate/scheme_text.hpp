// SPDX-License-Identifier: MIT
// Schemes by name or as text: "B(1/6) A(1/2) B(2/3, 1/48) A(1/2) B(1/6)".
#pragma once

#include <string>
#include <string_view>

#include "polhode/integrate/scheme.hpp"

namespace polhode {

/// The scheme of that name in the table, or the one that the text spells.
///
/// A text lists all stages: A(a) drifts and B(b) or B(b, xi) kicks, with a number or a fraction of
/// numbers for each argument; "xi=" before the second is allowed, and B(b, xi, fd) takes the
/// gradient by finite difference.
/// @throws Error  if there is no such name (with the nearest one), if the text cannot be read (with
///                the place), or if its drifts or kicks do not sum to one
Scheme scheme_of(std::string_view name_or_text);

/// All stages as text that scheme_of() reads back to the same bits.
std::string text_of(const Scheme& scheme);

}  // namespace polhode
