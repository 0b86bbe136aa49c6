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

/// The text of a requirement, as required_bias() reads it.
std::string text_of(const Requirement& requirement);

}  // namespace polhode
