// SPDX-License-Identifier: MIT
// The results of a run, as data and as JSON.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "polhode/run/adviser/guarantee.hpp"
#include "polhode/run/quantities.hpp"
#include "polhode/run/simulation/files/run_file_names.hpp"
#include "polhode/run/simulation/report/summary.hpp"
#include "polhode/run/simulation/report/warnings.hpp"

namespace polhode {

/// Hardware settings of a run: threads and instruction set.
struct ExecutionSettings {
  int threads = 1;
  std::string instruction_set;
};

struct RunReport {
  RunSummary summary;
  TrajectorySettings settings;
  ExecutionSettings execution;
  RunFileNames files;
  std::vector<Warning> warnings;  ///< warnings about probable mistakes
  std::optional<GuaranteeCheck>
      guarantee;  ///< check of a complete run at constant energy against its bound on R
  bool interrupted = false;
};

/// The results of a run as a list, from which text, JSON and the table of the manual are made.
Quantities run_quantities(const RunReport& report);

/// The report of a run as JSON. Names contain units, as in "length_ps"; unknown values are null.
std::string run_json(const RunReport& report);

}  // namespace polhode
