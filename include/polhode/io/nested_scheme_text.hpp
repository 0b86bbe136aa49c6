// SPDX-License-Identifier: MIT
// Multiple time steps as text: "hoa2 / hoa2 x 2 within 0.35 to 0.5 nm".
#pragma once

#include <string>
#include <string_view>

#include "polhode/integrate/nested_scheme.hpp"

namespace polhode {

/// Where near forces begin to fade, of where they end, if the text does not say.
inline constexpr double default_near_switch = 0.7;

/// The scheme of a name or text, as scheme_of() reads it, or two of them: "OUTER / INNER x STEPS
/// within [FROM to] CUTOFF", where FROM and CUTOFF have one unit.
/// @throws Error  as scheme_of(), or if what follows the slash cannot be read, or is out of its
/// domain
NestedScheme nested_scheme_of(std::string_view text);

/// The scheme of a name or text that has none within its drifts, for whoever serves such alone.
/// @throws Error  as nested_scheme_of(), or if there is one within
Scheme single_scheme_of(std::string_view text);

/// The same with names where schemes have them, else stages.
std::string name_of(const NestedScheme& scheme);

/// All stages as text that nested_scheme_of() reads back to the same bits.
std::string text_of(const NestedScheme& scheme);

}  // namespace polhode
