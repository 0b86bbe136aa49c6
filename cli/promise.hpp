// SPDX-License-Identifier: MIT
// The promise of [integrator] accuracy: the adviser chooses a step that keeps R below it, and at
// the end of the run it is told whether it was kept.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "polhode/run/adviser.hpp"

namespace polhode::cli {

struct Promise {
  double accuracy = 0;  ///< of R [1]
  double length = 0;    ///< of the stretches of a run that it is about [ps]
  Estimate expected;    ///< R, mean of the runs that confirmed it
};

/// Whether a run goes on from where it was left, and whether files that exist may be overwritten.
struct Beginning {
  bool go_on = false, force = false;
};

/// Chooses the step, and the scheme if the run file has none, where the run file asks for an
/// accuracy, and tells on standard error. Nothing where it does not, or after an interrupt. What
/// was chosen is kept in PREFIX-promise.json, and taken from there by a run that goes on: only with
/// the same scheme and step is it the same run.
/// @throws RunError  if no scheme keeps it
std::optional<Promise> promised(Config& config, Beginning beginning, Workers& workers);

struct Kept {
  Promise promise;
  /// R over stretches of the promised length, the mean; of the whole of a run that is not two
  /// stretches long. Error 0 where it is not known.
  Estimate ratio;
  bool kept() const { return ratio.value <= promise.accuracy; }
};

Kept checked(const Promise& promise, const TrajectoryStatistics& statistics);
void print_kept(const Kept& kept);
nlohmann::json as_json(const Kept& kept);

}  // namespace polhode::cli
