// SPDX-License-Identifier: MIT
// Reads the accuracy that a user requires of a run.
#pragma once

#include <string>

#include "polhode/io/settings/requirement.hpp"

namespace polhode {

/// The reason why a value is invalid as a bound on R; empty if it is valid.
std::string wrong_bound(double ratio);

/// Whether a text, possibly invalid, states a bound on the bias of an average rather than on R.
bool is_of_bias(const std::string& text);

/// Parses a bound on a bias, such as "0.1 K", "energy 0.01 kJ/mol", "pressure 4 bar" or "density
/// 0.02 %".
/// @param name  name of the option or key, for errors
/// @throws Error  if the text has none of these forms, or the bound is not above 0
Requirement required_bias(const std::string& text, const std::string& name);

}  // namespace polhode
