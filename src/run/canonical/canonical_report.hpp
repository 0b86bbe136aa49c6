// SPDX-License-Identifier: MIT
// A canonical study with all outputs: the record of runs, tables, JSON and a figure.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "polhode/run/canonical/canonical_study.hpp"
#include "polhode/run/outputs.hpp"
#include "run/study/study_report.hpp"

namespace polhode {

/// The result for a scheme: the steps that are accurate enough, by the same rule for all schemes.
struct CanonicalClaim {
  std::string scheme;
  /// The index of the point with the largest accurate step. At the largest accurate step and all
  /// shorter steps, the biases are below their bounds.
  std::optional<std::size_t> accurate;
  /// The index of the first point with a bias above its bound.
  std::optional<std::size_t> beyond;
};

/// The results of a study for one criterion (strict or loose).
struct CanonicalFindings {
  BiasCriterion criterion;
  std::vector<CanonicalClaim> claims{};  ///< results of each scheme, in the order of the points
  /// The index of the accurate point with the fewest force evaluations per sample.
  std::optional<std::size_t> cheapest{};
  std::vector<std::size_t> as_cheap{};  ///< other accurate points with an indistinguishable cost
  /// Points with undecided accuracy that are not significantly more expensive than the cheapest
  /// accurate point.
  std::vector<std::size_t> undecided{};

  CanonicalFindings(BiasCriterion criterion, const std::vector<CanonicalPoint>& points);
};

/// The results of the runs of a canonical study.
struct CanonicalReport {
  Config config;
  std::vector<CanonicalPoint> points;
  std::array<CanonicalFindings, 2> findings;  ///< findings for the strict and for the loose
                                              ///< criterion
  std::vector<std::string> files{};           ///< paths of the files that were written
  bool interrupted = false;                   ///< whether the study was interrupted before all runs
                                              ///< were done

  CanonicalReport(const Config& config, const std::vector<CanonicalPoint>& points);
};

/// Performs a canonical study, or makes the tables and the figure of an existing record, with the
/// arguments and under the conditions of run_study(). Only this version's records can be read.
CanonicalReport run_canonical_study(const Config& config, const std::string& record,
                                    const std::string& prefix, const OutputOptions& options,
                                    const Callbacks& callbacks, Workers& workers);

/// The results of a canonical study as a list, for text, JSON, the table of points and the manual.
Quantities quantities(const CanonicalReport& report);

/// Conclusions for a criterion: a sentence for each scheme, and a sentence on the cheapest sample.
std::vector<std::string> canonical_sentences(const CanonicalFindings& findings,
                                             const std::vector<CanonicalPoint>& points);

/// The name of a criterion: "strict" or "loose".
const char* in_words(BiasCriterion criterion);

/// The result of a comparison as text: "below the bound", "above the bound" or "undecided".
const char* in_words(Accuracy accuracy);

}  // namespace polhode
