// SPDX-License-Identifier: MIT
// The adviser with its outputs: text, JSON, a table and a figure.
#pragma once

#include <string>
#include <vector>

#include "polhode/run/adviser/adviser.hpp"
#include "polhode/run/outputs.hpp"
#include "polhode/run/quantities.hpp"

namespace polhode {

struct AdviceFiles {
  std::string prefix, points, json, script, figure;

  /// @param plot  "svg", "png" or "none"
  AdviceFiles(const std::string& common, const std::string& plot);
  std::vector<std::string> all() const;
};

/// The advice, and the requirement that it answers.
struct AdviceReport {
  Advice advice;
  Criterion criterion;
  int threads = 1;
  AdviceFiles files;
};

/// Advice for a run file, see advise(), and its outputs; none if it was interrupted.
/// @param prefix  of the output files
/// @throws Error  before anything is computed, if outputs exist or a setting does not fit
AdviceReport run_adviser(const Config& config, const AdviserSettings& settings,
                         const std::string& prefix = "advice", const OutputOptions& options = {},
                         const Callbacks& callbacks = {}, Workers& workers = Workers::serial());

/// The results as a list, from which text, JSON, the table of points and the manual follow.
Quantities quantities(const AdviceReport& report);

/// A bound on a quality in the unit that users enter: "0.5 %", "0.1 kJ/mol/ns".
std::string bound_text(Quality quality, double bound);

/// "an R of at most 0.5 %".
std::string description(const Criterion& criterion);

/// Why no scheme was found, and what to change.
std::string unreachable(const Advice& advice, const Criterion& criterion);

/// "hoa2 at 4.52 fs, R = 0.44 ± 0.01 % in 8 independent runs of 15 ps"
std::string answer(const Advice& advice);

}  // namespace polhode
