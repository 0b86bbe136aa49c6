// SPDX-License-Identifier: MIT
// What a run file or a command line requires of the accuracy of a run, as text: "0.5 %" of R, "0.1
// K" and others of the bias of averages.
#pragma once

#include <string>

namespace polhode {

/// Of which quantity the error is bounded.
enum class RequiredOf {
  ratio,                   ///< R [1]
  temperature_difference,  ///< bias of T_rot − T_trans [K]
  energy,                  ///< bias of the potential energy per molecule [kJ/mol]
  pressure,                ///< its bias [kJ/mol/nm³]
  density                  ///< its relative bias at constant pressure [1]
};

struct Requirement {
  RequiredOf of = RequiredOf::ratio;
  double bound = 0;
  friend bool operator==(const Requirement&, const Requirement&) = default;
};

/// Empty if R can be bounded so, otherwise why not.
std::string wrong_bound(double ratio);

/// Whether a text is about the bias of an average and not about R: not whether it is valid.
bool is_of_bias(const std::string& text);

/// "0.1 K", "energy 0.01 kJ/mol", "pressure 4 bar", "density 0.02 %".
/// @param name  of the option or key, for errors
/// @throws Error  if it is none of these, or not above 0
Requirement required_bias(const std::string& text, const std::string& name);

/// The text of a requirement.
std::string text_of(const Requirement& requirement);

}  // namespace polhode
