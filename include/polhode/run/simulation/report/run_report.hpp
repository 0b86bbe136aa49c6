// SPDX-License-Identifier: MIT
// The results of a run, as data and as JSON.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "polhode/run/adviser/guarantee.hpp"
#include "polhode/run/quantities.hpp"
#include "polhode/run/simulation/files/run_file_names.hpp"
#include "polhode/run/simulation/report/warnings.hpp"

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
      guarantee;  ///< check of a complete run with a bound on R, at constant energy
  bool interrupted = false;
};

/// "significant", "not significant", or why this is not known.
std::string verdict(const Drift& drift);

/// "R = 0.31 ± 0.02 % over 15 ps; the accuracy guarantee is 0.4 %", or the bias.
std::string guarantee_text(const GuaranteeCheck& check);

/// The results as a list, from which text, JSON and the manual's table follow.
Quantities run_quantities(const RunReport& report);

/// The results as lines of text, without files and warnings.
std::string run_text(const RunReport& report);

/// The report as JSON. Names contain units, as in "length_ps"; unknown values are null.
std::string run_json(const RunReport& report);

}  // namespace polhode
