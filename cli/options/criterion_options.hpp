// SPDX-License-Identifier: MIT
// The options of polhode advise that say what is required of a run.
#pragma once

#include <string>

#include "command.hpp"
#include "polhode/io/settings/config.hpp"
#include "polhode/run/adviser/criterion.hpp"

namespace polhode::cli {

/// At most one is given.
struct CriterionOptions {
  std::string accuracy, drift, temperature_bias, bias;

  void declare(Command& command);
};

/// What the options require, or the accuracy of the run file where none is given.
/// @throws Error  if there is neither, or a bound is not positive, or a fraction not below 1
Criterion criterion_option(const CriterionOptions& options, const Config& config);

}  // namespace polhode::cli
