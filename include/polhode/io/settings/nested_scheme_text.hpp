// SPDX-License-Identifier: MIT
// Multiple time steps as text: "hoa2 / hoa2 x 2 within 0.35 to 0.5 nm".
#pragma once

#include <string>
#include <string_view>

#include "polhode/integrate/nested_scheme.hpp"

namespace polhode {

/// Default start of the switch of the near forces, relative to their cutoff.
inline constexpr double default_near_switch = 0.7;

/// The scheme of a name or text, as scheme_of() reads it, or a nested one: "OUTER / INNER x STEPS
/// within [FROM to] CUTOFF", where FROM and CUTOFF share one unit.
/// @throws Error  as scheme_of(), or if the part after the slash cannot be parsed or is out of its
///                domain, or if the inner scheme has a bath
NestedScheme nested_scheme_of(std::string_view text);

/// A scheme as it was given, parsed once.
struct NamedScheme : NestedScheme {
  std::string text;  ///< name, or stages

  /// @throws Error  as nested_scheme_of()
  NamedScheme(std::string text);
  NamedScheme(const char* text) : NamedScheme(std::string(text)) {}

  friend bool operator==(const NamedScheme& one, const NamedScheme& other) {
    return one.text == other.text;
  }
};

/// A scheme that must not be nested, for callers that support no multiple time steps.
/// @throws Error  if it is
Scheme single_scheme_of(const NamedScheme& scheme);

/// A nested scheme as text: the names of schemes that have one, otherwise their stages.
std::string name_of(const NestedScheme& scheme);

/// The label of a scheme in tables and figures. It is the scheme's name if it has one, otherwise
/// the text with single spaces between its words, or the stages if the text defines names.
std::string label_of(const NamedScheme& scheme);

/// Names of the table, and stages with user-given names, as text that nested_scheme_of() reads back
/// to the same bits.
std::string named_text_of(const NestedScheme& scheme);

/// All stages as text that nested_scheme_of() reads back to the same bits.
std::string text_of(const NestedScheme& scheme);

}  // namespace polhode
