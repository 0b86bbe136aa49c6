// SPDX-License-Identifier: MIT
// The accuracy guarantee of [integrator] accuracy: the adviser chooses a step that keeps R below
// the bound, and at the end of the run it is reported whether R was below it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "polhode/run/adviser/adviser.hpp"

namespace polhode::cli {

struct Guarantee {
  double accuracy = 0;  ///< bound on R [1]
  double length = 0;    ///< of the sections of a run to which the bound applies [ps]
  Estimate expected;    ///< R, mean of the confirming runs
};

/// Whether a suspended run is resumed, and whether existing files may be overwritten.
struct StartMode {
  bool resume = false, force = false;
};

/// If the run file has an accuracy guarantee, chooses the step, and the scheme unless the run file
/// has one, and reports them on standard error. Empty otherwise, and after an interrupt. The choice
/// is saved in PREFIX-guarantee.json, from which a resumed run takes it: it must continue with the
/// same scheme and step.
/// @throws RunError  if no scheme meets the bound
std::optional<Guarantee> choose_guaranteed_step(Config& config, StartMode start_mode,
                                                Workers& workers);

struct GuaranteeCheck {
  Guarantee guarantee;
  /// Mean R over stretches of the guaranteed length; over the whole run if it is shorter than two
  /// stretches. The error is 0 if it is not known.
  Estimate ratio;
  bool met() const { return ratio.value <= guarantee.accuracy; }
};

GuaranteeCheck check_guarantee(const Guarantee& guarantee, const TrajectoryStatistics& statistics);
void print_guarantee(const GuaranteeCheck& check);
nlohmann::json as_json(const GuaranteeCheck& check);

}  // namespace polhode::cli
