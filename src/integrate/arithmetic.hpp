// SPDX-License-Identifier: MIT
// Arithmetic in the text of a scheme: numbers, names, + - * / ^, parentheses, sqrt and cbrt.
#pragma once

#include <map>
#include <string>

#include "scanner.hpp"

namespace polhode {

/// Names defined earlier in the text of a scheme, with their values.
using NamedValues = std::map<std::string, double, std::less<>>;

/// Reads an expression and returns its value in double precision. Operators have the usual
/// precedence, from left to right: -x^2 is -(x^2), and 2^3^2 is 2^(3^2).
/// @throws Error  with the position, for an unknown name, a division by zero, a root of a negative
///   number, a result that is not finite, or parentheses nested too deeply
double expression(Scanner& scanner, const NamedValues& names);

/// Whether a word is a function of expressions, and therefore not allowed as a name.
bool is_function(std::string_view word);

}  // namespace polhode
