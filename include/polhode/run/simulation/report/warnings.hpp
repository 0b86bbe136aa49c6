// SPDX-License-Identifier: MIT
// What is probably wrong with a simulation, with what to do about it.
#pragma once

#include <string>

namespace polhode {

/// A warning about a probable mistake. It neither ends the run nor changes its exit code.
struct Warning {
  std::string kind;  ///< "temperature", "R", "drift", "walk", "truncation", "relaxation",
                     ///< "pressure", "ions", "step", "volume", "barostat", "acceptance" or
                     ///< "weights"; at the start also "velocities"
  double value = 0;  ///< what was found, in the unit that `text` gives
  double bound = 0;  ///< what it exceeds, likewise
  std::string text;
  std::string remedy;
};

}  // namespace polhode
