// SPDX-License-Identifier: MIT
// What a run tells at its end, for eyes and for machines.
#pragma once

#include <optional>
#include <string>

#include "polhode/run/run_files.hpp"
#include "polhode/run/summary.hpp"
#include "promise.hpp"

namespace polhode::cli {

/// What the run was computed with.
struct Means {
  int threads;
  std::string target;
};

void print_summary(const RunSummary& summary, const TrajectorySettings& settings,
                   const Means& means);

void print_json(const RunSummary& summary, const TrajectorySettings& settings, const Means& means,
                const RunFileNames& files, const std::optional<Kept>& kept, bool stopped);

}  // namespace polhode::cli
