// SPDX-License-Identifier: MIT
// A canonical study with its outputs: the record of its runs, tables, JSON and a figure.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "polhode/run/canonical/canonical_study.hpp"
#include "polhode/run/outputs.hpp"
#include "run/study/study_report.hpp"

namespace polhode {

/// What the points say about one scheme: which steps are accurate enough, by the same rule for all
/// schemes.
struct CanonicalClaim {
  std::string scheme;
  /// The largest step whose biases are all below their bounds, as are those of all shorter ones; an
  /// index of the points.
  std::optional<std::size_t> accurate;
  /// The first step with a bias above its bound.
  std::optional<std::size_t> beyond;
};

/// What the points show by one criterion.
struct CanonicalFindings {
  BiasCriterion criterion;
  std::vector<CanonicalClaim> claims{};  ///< of each scheme, in the order of the points
  /// Of the accurate points, by force evaluations per sample.
  std::optional<std::size_t> cheapest{};
  std::vector<std::size_t> as_cheap{};  ///< others that are not distinguishable from it
  /// Points of which the data do not show whether they are accurate, and that are not more
  /// expensive than the cheapest, as far as can be distinguished.
  std::vector<std::size_t> undecided{};

  CanonicalFindings(BiasCriterion criterion, const std::vector<CanonicalPoint>& points);
};

/// The results of the runs of a canonical study.
struct CanonicalReport {
  Config config;
  std::vector<CanonicalPoint> points;
  std::array<CanonicalFindings, 2> findings;  ///< by the strict and the loose criterion
  std::vector<std::string> files{};           ///< that were written
  bool interrupted = false;                   ///< before all runs were done

  CanonicalReport(const Config& config, const std::vector<CanonicalPoint>& points);
};

/// Performs a canonical study and writes its record, tables and figure. The runs of a record that
/// exists are not repeated, unless existing files are to be replaced: a study that was interrupted
/// resumes.
/// @param prefix  of the output files
/// @throws Error  before anything is computed, if a setting does not fit, or outputs of another
///                study exist
CanonicalReport run_canonical_study(const Config& config, const std::string& prefix = "study",
                                    const OutputOptions& options = {},
                                    const Callbacks& callbacks = {},
                                    Workers& workers = Workers::serial());

/// Tables and figure of an existing record, without new runs.
/// @throws Error  as run_canonical_study(), or if there is no such record
CanonicalReport report_canonical_record(const Config& config, const std::string& record,
                                        const std::string& prefix = "study",
                                        const OutputOptions& options = {},
                                        const Callbacks& callbacks = {});

/// The results as a list, from which text, JSON, the table of points and the manual follow.
Quantities quantities(const CanonicalReport& report);

/// Forces, runs and bath of a canonical study, in a sentence.
std::string canonical_conditions(const Config& config);

/// What the points show by one criterion, a sentence for each scheme and one for the cheapest
/// sample.
std::vector<std::string> canonical_sentences(const CanonicalFindings& findings,
                                             const std::vector<CanonicalPoint>& points);

}  // namespace polhode
