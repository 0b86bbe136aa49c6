// SPDX-License-Identifier: MIT
// The results of a run, as data and as JSON.
#pragma once

#include <optional>
#include <string>

#include "polhode/run/adviser/guarantee.hpp"
#include "polhode/run/simulation/run_files.hpp"
#include "polhode/run/simulation/summary.hpp"

namespace polhode {

/// What computes a run, besides the program.
struct ExecutionSettings {
  int threads = 1;
  std::string instruction_set;
};

struct RunReport {
  RunSummary summary;
  TrajectorySettings settings;
  ExecutionSettings execution;
  RunFileNames files;
  std::optional<GuaranteeCheck> guarantee;  ///< of a complete run with a bound on R
  bool interrupted = false;
};

/// Fewer samples show no fluctuation and no slope at all.
inline constexpr std::uint64_t min_samples_reported = 3;

/// "significant", "not significant", or why it is not known which.
std::string verdict(const Drift& drift);

/// Names with units in front of their underscore, as "length_ps"; what is not known is null.
std::string run_json(const RunReport& report);

}  // namespace polhode
