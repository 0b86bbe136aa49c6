// SPDX-License-Identifier: MIT
// Multiple time steps as text: "hoa2 / hoa2 x 2 within 0.35 to 0.5 nm".
#pragma once

#include <string>
#include <string_view>

#include "polhode/integrate/nested_scheme.hpp"

namespace polhode {

/// Default switching distance of the near forces, relative to the cutoff of the near forces.
inline constexpr double default_near_switch = 0.7;

/// Parses a scheme from a name or text. A single scheme is written as in scheme_of(). A nested
/// scheme is written as "OUTER / INNER x STEPS within [FROM to] CUTOFF". FROM and CUTOFF have the
/// same unit.
/// @throws Error  if scheme_of() would throw, if the part after the slash is invalid, or if the
///   inner scheme has a bath
NestedScheme nested_scheme_of(std::string_view text);

/// A scheme given by the user, as a parsed scheme and as the text that the user wrote.
struct NamedScheme : NestedScheme {
  std::string text;  ///< name, or stages as text

  /// Parses the text of a scheme.
  /// @throws Error  under the same conditions as nested_scheme_of()
  NamedScheme(std::string text);
  NamedScheme(const char* text) : NamedScheme(std::string(text)) {}

  friend bool operator==(const NamedScheme& one, const NamedScheme& other) {
    return one.text == other.text;
  }
};

/// A nested scheme as text. Each of the two schemes is given by its name, or by its stages if it is
/// unnamed.
std::string name_of(const NestedScheme& scheme);

/// All stages of a nested scheme as text that nested_scheme_of() reads back to bitwise the same
/// coefficients.
std::string text_of(const NestedScheme& scheme);

}  // namespace polhode
