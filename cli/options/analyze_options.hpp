// SPDX-License-Identifier: MIT
// The options of polhode analyze, as typed and as settings.
#pragma once

#include <string>

#include "run/analysis/analysis_report.hpp"

namespace polhode::cli {

struct AnalyzeOptions {
  std::string trajectory, run, energies, molecules, names, what, output = AnalysisInput{}.prefix,
                                                                 plot = AnalysisInput{}.plot;
  std::string from, interval, window, fit, pairs, cutoff, bin, viscosity, temperature,
      electrostatics, threads;
  bool force = false, json = false;
};

/// @throws Error  naming the option, if one cannot be understood
AnalysisInput analysis_input(const AnalyzeOptions& options);

/// The command as it could be typed.
std::string analyze_command(const AnalyzeOptions& options);

}  // namespace polhode::cli
