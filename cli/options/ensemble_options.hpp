// SPDX-License-Identifier: MIT
// The options that set thermostat, barostat and hybrid Monte Carlo of a run.
#pragma once

#include <string>
#include <vector>

#include "command.hpp"
#include "polhode/io/settings/config.hpp"

namespace polhode::cli {

struct EnsembleOptions {
  std::string thermostat, friction, time_constant, barostat, pressure, hybrid_steps;

  void declare(Command& command);

  /// Applies those that are given to the run file's settings. A pressure without a barostat selects
  /// the default one, and the default thermostat unless the run has a thermostat or is hybrid Monte
  /// Carlo.
  /// @return  notes on what was selected by default
  /// @throws Error  naming the option, if a value has no meaning for the kind, or is out of bounds
  std::vector<std::string> apply(Config& config) const;
};

}  // namespace polhode::cli
