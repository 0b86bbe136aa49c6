// SPDX-License-Identifier: MIT
// Schemes in tables, figures and records.
#pragma once

#include <string>

#include "polhode/io/settings/nested_scheme_text.hpp"

namespace polhode {

/// The scheme as a single scheme, for callers that do not support multiple time steps.
/// @throws Error  if the scheme is nested
Scheme single_scheme_of(const NamedScheme& scheme);

/// The label of a scheme in tables and figures. For a named scheme it is the name. For an unnamed
/// scheme it is the text with single spaces between words, or the stages if the text defines names.
std::string label_of(const NamedScheme& scheme);

/// A scheme as text that nested_scheme_of() reads back to the same bits. Schemes of the table are
/// given by name, and other schemes by their user-given name and stages.
std::string named_text_of(const NestedScheme& scheme);

}  // namespace polhode
