// SPDX-License-Identifier: MIT
// The results of a run, as text and as JSON.
#pragma once

#include <optional>
#include <string>

#include "polhode/run/run_files.hpp"
#include "polhode/run/summary.hpp"
#include "promise.hpp"

namespace polhode::cli {

/// Execution settings of a run.
struct Means {
  int threads;
  std::string target;
};

void print_summary(const RunSummary& summary, const TrajectorySettings& settings,
                   const Means& means);

void print_json(const RunSummary& summary, const TrajectorySettings& settings, const Means& means,
                const RunFileNames& files, const std::optional<Kept>& kept, bool stopped);

}  // namespace polhode::cli
