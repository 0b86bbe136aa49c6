// SPDX-License-Identifier: MIT
// Schemes by name or as text: "B(1/6) A(1/2) B(2/3, 1/48) A(1/2) B(1/6)".
#pragma once

#include <string>
#include <string_view>

#include "polhode/integrate/scheme.hpp"

namespace polhode {

/// The scheme of that name in the table, or the one that the text describes.
///
/// A text lists all stages: A(a) for drifts and B(b) or B(b, xi) for kicks. Each argument is a
/// number or a fraction of two numbers; "xi=" is allowed before the second one, and B(b, xi, fd)
/// computes the gradient by finite difference.
/// @throws Error  if the name is unknown (suggesting the nearest one), if the text cannot be parsed
///                (with the position), or if its drifts or kicks do not sum to one
Scheme scheme_of(std::string_view name_or_text);

/// All stages as text; scheme_of() reproduces the same bits from it.
std::string text_of(const Scheme& scheme);

}  // namespace polhode
