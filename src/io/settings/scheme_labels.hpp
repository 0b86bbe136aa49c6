// SPDX-License-Identifier: MIT
// Labels and texts of schemes for tables, figures and records.
#pragma once

#include <string>

#include "polhode/io/settings/nested_scheme_text.hpp"

namespace polhode {

/// The scheme as a single scheme, for callers that do not support multiple time steps.
/// @throws Error  if the scheme is nested
Scheme single_scheme_of(const NamedScheme& scheme);

/// The label of a scheme in tables and figures. The label of a named scheme is its name. The label
/// of an unnamed scheme is its text with single spaces between words, or the stages if the text
/// defines names.
std::string label_of(const NamedScheme& scheme);

/// A scheme as text that nested_scheme_of() reads back with bitwise identical coefficients.
/// Built-in schemes are given by name, and other schemes by their user-given name and stages.
std::string named_text_of(const NestedScheme& scheme);

}  // namespace polhode
