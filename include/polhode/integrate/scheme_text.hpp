// SPDX-License-Identifier: MIT
// Schemes by name or as text: "mine: x = 1/6; B(x) A(1/2) B(1 - 2*x) A(1/2) B(x)".
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "polhode/integrate/scheme.hpp"

namespace polhode {

/// A name in the text of a scheme that tune() may vary, with its value.
struct FreeParameter {
  std::string name;
  double value = 0;
};

/// The scheme of that name in the table, or the one that the text describes.
///
/// A text lists all stages: A(a) for drifts and B(b) or B(b, xi) for kicks. "xi=" is allowed before
/// the second argument, and B(b, xi, fd) computes the gradient by finite difference. Arguments are
/// expressions of numbers, + - * / ^, parentheses, sqrt(), cbrt(), and names. Names are defined
/// before the stages: "x = 1/sqrt(3); B(x) A(1/2) ...". With "free x = 0.2;" the name is a
/// parameter that tune() varies. "mine: ..." at the beginning gives the scheme a name.
///
/// Its order is 2 if it is a palindrome with an error of order h², otherwise unknown.
/// @param values  for free parameters, instead of the values in the text
/// @throws Error  if the name is unknown, with a suggestion; if the text cannot be parsed, with the
///                position; if its drifts or kicks do not sum to one
Scheme scheme_of(std::string_view name_or_text, std::span<const FreeParameter> values = {});

/// The free parameters of a text, in the order of their definitions; none for a name of the table.
/// @throws Error  as scheme_of()
std::vector<FreeParameter> free_parameters(std::string_view name_or_text);

/// All stages as text, without the name; scheme_of() reproduces the same bits from it.
std::string text_of(const Scheme& scheme);

}  // namespace polhode
