// SPDX-License-Identifier: MIT
// The results of a run, as data and as JSON.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "polhode/run/adviser/guarantee.hpp"
#include "polhode/run/simulation/run_files.hpp"
#include "polhode/run/simulation/warnings.hpp"

namespace polhode {

/// What a run is computed with.
struct ExecutionSettings {
  int threads = 1;
  std::string instruction_set;
};

struct RunReport {
  RunSummary summary;
  TrajectorySettings settings;
  ExecutionSettings execution;
  RunFileNames files;
  std::vector<Warning> warnings;  ///< what is probably wrong
  std::optional<GuaranteeCheck>
      guarantee;  ///< of a complete run with a bound on R, at constant energy
  bool interrupted = false;
};

/// "significant", "not significant", or why this is not known.
std::string verdict(const Drift& drift);

/// Why an error is not known: "too few samples", "run too short" or "not defined"; empty if it is.
std::string reason(Known known);

/// The report as JSON. Names contain units, as in "length_ps"; unknown values are null.
std::string run_json(const RunReport& report);

}  // namespace polhode
