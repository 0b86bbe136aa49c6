// SPDX-License-Identifier: MIT
// The options that a front end received for an analysis, as texts.
#pragma once

#include <string>
#include <vector>

#include "run/analysis/analysis_report.hpp"
#include "run/given.hpp"

namespace polhode {

struct AnalysisRequest {
  Given run, energies, molecules, names, what, start, interval, window, fit, pairs, cutoff, bin,
      viscosity, temperature, electrostatics, output, plot;

  static std::vector<RequestOption<AnalysisRequest>> options();
};

/// Makes the input of an analysis from a request.
/// @param trajectory  file of frames
/// @param run         settings of the run that wrote the trajectory; if null, the request gives its
///   run file or the molecules
/// @throws Error  if an option cannot be understood; the message names the option
AnalysisInput analysis_input(const AnalysisRequest& request, const std::string& trajectory,
                             const Config* run = nullptr);

}  // namespace polhode
