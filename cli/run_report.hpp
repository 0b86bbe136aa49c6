// SPDX-License-Identifier: MIT
// The results of a run, as text and as JSON.
#pragma once

#include <optional>
#include <string>

#include "guarantee.hpp"
#include "polhode/run/simulation/run_files.hpp"
#include "polhode/run/simulation/summary.hpp"

namespace polhode::cli {

/// Execution settings of a run.
struct ExecutionSettings {
  int threads;
  std::string instruction_set;
};

void print_summary(const RunSummary& summary, const TrajectorySettings& settings,
                   const ExecutionSettings& execution);

void print_json(const RunSummary& summary, const TrajectorySettings& settings,
                const ExecutionSettings& execution, const RunFileNames& files,
                const std::optional<GuaranteeCheck>& check, bool stopped);

}  // namespace polhode::cli
