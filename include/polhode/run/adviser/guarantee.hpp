// SPDX-License-Identifier: MIT
// The guarantee that `accuracy` in [integrator] requests. The adviser chooses a step that keeps R,
// or the bias of an average, below the bound. The run's summary reports whether the bound was met.
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "polhode/io/settings/config.hpp"
#include "polhode/measure/energy_statistics.hpp"
#include "polhode/run/callbacks.hpp"
#include "polhode/run/simulation/report/summary.hpp"

namespace polhode {

struct Guarantee {
  Requirement accuracy;
  double length = 0;  ///< length of the sections of a run to which a bound on R applies [ps]
  Estimate expected;  ///< mean R of the runs that confirmed the step
};

/// Chooses the step that meets the accuracy of a run file, and also the scheme if the run file has
/// none. Sets both in `config`. The result is empty if the search was interrupted.
/// @param config  settings that include integrator.accuracy
/// @throws RunError  if no scheme meets the bound
std::optional<Guarantee> choose_guaranteed_step(Config& config, const Callbacks& callbacks,
                                                Workers& workers);

/// Writes a guarantee with the chosen scheme and step to a file. A resumed run needs the file to
/// continue with the same scheme and step.
void write_guarantee(const std::string& file, const Guarantee& guarantee,
                     const IntegratorSettings& integrator);

/// Reads a guarantee from a file, and sets its scheme and step.
/// @throws Error  if the file contains no guarantee, or if the run file does not match it
Guarantee read_guarantee(const std::string& file, Config& config);

struct GuaranteeCheck {
  Guarantee guarantee;
  /// Measured value of the bounded quantity. If R is bounded, the measured value is the mean R over
  /// parts of the guaranteed length. For a run shorter than two parts, the value is the R of the
  /// whole run. If a bias is bounded, the value is the predicted bias. An error of 0 means that the
  /// error is not known.
  Estimate value;
  bool met() const { return std::abs(value.value) <= guarantee.accuracy.bound; }
};

/// Checks a run against its guarantee. The result is empty if R or the bias is not known. For
/// example, R is not known with a thermostat.
std::optional<GuaranteeCheck> check_guarantee(const Guarantee& guarantee,
                                              const TrajectoryStatistics& statistics,
                                              const RunSummary& summary);

/// A guarantee check as text, such as "R = 0.31 ± 0.02 % over 15 ps; the accuracy guarantee is 0.4
/// %". If a bias is bounded, the text gives the bias instead of R.
std::string guarantee_text(const GuaranteeCheck& check);

}  // namespace polhode
