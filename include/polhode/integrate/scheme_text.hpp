// SPDX-License-Identifier: MIT
// Schemes by name or as text: "mine: x = 1/6; B(x) A(1/2) B(1 - 2*x) A(1/2) B(x)".
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "polhode/integrate/scheme.hpp"

namespace polhode {

/// A free parameter in the text of a scheme, which tune() may vary.
struct FreeParameter {
  std::string name;
  double value = 0;
};

/// The scheme with a given name in the table, or the scheme that a text describes.
///
/// A text lists all stages: A(a) for drifts and B(b) or B(b, xi) for kicks. "xi=" is allowed before
/// the second argument, and B(b, xi, fd) computes the gradient by finite difference. Arguments are
/// expressions of numbers, + - * / ^, parentheses, sqrt(), cbrt(), and names. Names are defined
/// before the stages: "x = 1/sqrt(3); B(x) A(1/2) ...". With "free x = 0.2;" the name is a
/// parameter that tune() varies. "mine: ..." at the beginning gives the scheme a name.
///
/// The order is 2 if the scheme is a palindrome with an error of order h², otherwise it is unknown.
/// @param values  values of free parameters, which replace the values in the text
/// @throws Error  if the name is unknown, the text cannot be parsed, or the fractions of the drifts
///   or kicks do not sum to one. The message suggests a similar name or gives the position of the
///   error
Scheme scheme_of(std::string_view name_or_text, std::span<const FreeParameter> values = {});

/// The free parameters of a scheme text, in the order of their definitions. A scheme given by its
/// name in the table has no free parameters.
/// @throws Error  under the same conditions as scheme_of()
std::vector<FreeParameter> free_parameters(std::string_view name_or_text);

/// All stages of a scheme as text, without its name. scheme_of() reads this text back to bitwise
/// the same coefficients.
std::string text_of(const Scheme& scheme);

}  // namespace polhode
