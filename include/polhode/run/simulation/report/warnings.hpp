// SPDX-License-Identifier: MIT
// Warnings about probable mistakes in a simulation, with advice.
#pragma once

#include <string>

namespace polhode {

/// A warning about a probable mistake. A warning neither ends the run nor changes its exit code.
struct Warning {
  std::string kind;  ///< "temperature", "R", "drift", "walk", "truncation", "relaxation",
                     ///< "pressure", "ions", "step", "volume", "barostat", "acceptance" or
                     ///< "weights"; at the start also "velocities"
  double value = 0;  ///< measured value that caused the warning, in the unit that `text` gives
  double bound = 0;  ///< what it exceeds, likewise
  std::string text;
  std::string remedy;
};

}  // namespace polhode
