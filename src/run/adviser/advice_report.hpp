// SPDX-License-Identifier: MIT
// The adviser with all outputs: text, JSON, a table and a figure.
#pragma once

#include <string>
#include <vector>

#include "polhode/run/adviser/adviser.hpp"
#include "polhode/run/outputs.hpp"
#include "polhode/run/quantities.hpp"
#include "run/study/guideline.hpp"

namespace polhode {

struct AdviceFiles {
  std::string prefix, points, json, script, figure;

  /// Names the output files of the adviser.
  /// @param plot  format of the figure: "svg", "png" or "none"
  AdviceFiles(const std::string& common, const std::string& plot);
  std::vector<std::string> all() const;
};

/// The advice, with the requirement that the advice meets.
struct AdviceReport {
  Advice advice;
  Criterion criterion;
  int threads = 1;
  AdviceFiles files;
};

/// Runs the adviser for a run file, see advise(), and writes its outputs. No output is written if
/// the adviser is interrupted.
/// @param prefix  prefix of the output files
/// @throws Error  before anything is computed, if outputs exist or a setting is invalid
AdviceReport run_adviser(const Config& config, const AdviserSettings& settings,
                         const std::string& prefix = "advice", const OutputOptions& options = {},
                         const Callbacks& callbacks = {}, Workers& workers = Workers::serial());

/// The results of the adviser as a list, for text, JSON, the table of points and the manual.
Quantities quantities(const AdviceReport& report);

/// The test runs of a candidate at one step, as a point of a figure.
EfficiencyPoint efficiency_point(const Candidate& candidate, const AdviserPoint& point);

/// The curves of all candidates, with points ordered by step. The curves contain the exploratory
/// and the confirming runs that the adviser considered usable.
std::vector<Curve> curves(const Advice& advice);

/// A bound as text, in the unit in which users enter it: "0.5 %" or "0.1 kJ/mol/ns".
std::string bound_text(Quality quality, double bound);

/// A criterion as text, such as "an R of at most 0.5 %".
std::string description(const Criterion& criterion);

/// The reason why no scheme was found, with advice on what to change.
std::string unreachable(const Advice& advice, const Criterion& criterion);

/// The chosen scheme and step as text, such as "hoa2 at 4.52 fs, R = 0.44 ± 0.01 % in 8 independent
/// runs of 15 ps".
std::string answer(const Advice& advice);

}  // namespace polhode
