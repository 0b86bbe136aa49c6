// SPDX-License-Identifier: MIT
// The accuracy that a run file or a command line requires of a run, as text. Examples are "0.5 %"
// for R and "0.1 K" for the bias of averages.
#pragma once

#include <string>

namespace polhode {

/// The quantities whose error can be bounded.
enum class RequiredOf {
  ratio,                   ///< energy fluctuation ratio R [1]
  temperature_difference,  ///< bias of the temperature difference T_rot − T_trans [K]
  energy,                  ///< bias of the potential energy per molecule [kJ/mol]
  pressure,                ///< bias of the pressure [kJ/mol/nm³]
  density                  ///< relative bias of the density at constant pressure [1]
};

struct Requirement {
  RequiredOf of = RequiredOf::ratio;
  double bound = 0;
  friend bool operator==(const Requirement&, const Requirement&) = default;
};

/// The reason why R cannot be bounded by a value; empty if the value is valid.
std::string wrong_bound(double ratio);

/// Whether a text requires the bias of an average rather than R; the text need not be valid.
bool is_of_bias(const std::string& text);

/// Parses a bound on a bias, such as "0.1 K", "energy 0.01 kJ/mol", "pressure 4 bar" or "density
/// 0.02 %".
/// @param name  name of the option or key, for errors
/// @throws Error  if the text has none of these forms, or the bound is not above 0
Requirement required_bias(const std::string& text, const std::string& name);

/// The text of a requirement, as required_bias() reads it.
std::string text_of(const Requirement& requirement);

}  // namespace polhode
