// SPDX-License-Identifier: MIT
// A study with all outputs: the record of runs, tables, JSON and a figure.
#pragma once

#include <string>
#include <vector>

#include "polhode/run/outputs.hpp"
#include "polhode/run/quantities.hpp"
#include "run/study/claims.hpp"
#include "run/study/equipartition.hpp"

namespace polhode {

struct StudyFiles {
  std::string prefix, runs, points, json, script, svg, png;

  explicit StudyFiles(const std::string& common)
      : prefix(common),
        runs(prefix + "-runs.csv"),
        points(prefix + ".csv"),
        json(prefix + ".json"),
        script(prefix + ".gp"),
        svg(prefix + ".svg"),
        png(prefix + ".png") {}
  /// The paths of all output files of a study except the record.
  std::vector<std::string> tables() const { return {points, json, script, svg, png}; }
  std::vector<std::string> all() const { return {points, runs, json, script, svg, png}; }
};

/// The results of the runs of a study.
struct StudyReport {
  Config config;
  std::vector<EfficiencyPoint> points;
  std::vector<Curve> curves;
  std::vector<Guideline> guidelines;
  std::vector<Claim> claims;
  std::vector<EquipartitionFit> equipartition;
  std::vector<std::string> files{};  ///< paths of the files that were written
  bool interrupted = false;          ///< whether the study was interrupted before all runs were
                                     ///< done

  StudyReport(const Config& config, const std::vector<EfficiencyPoint>& points);
};

/// Performs a study and writes its record, tables and figure. An interrupted study resumes: runs in
/// an existing record are not repeated, unless the user asked to replace existing files.
/// @param record  existing record of any version, whose tables and figure are made without new
///   runs; empty to perform the study
/// @param prefix  prefix of the output files
/// @throws Error  before anything is computed, if a setting is invalid, outputs of another study
///   exist, or the given record does not exist
StudyReport run_study(const Config& config, const std::string& record, const std::string& prefix,
                      const OutputOptions& options, const Callbacks& callbacks, Workers& workers);

/// The results of a study as a list, for text, JSON, the table of points and the manual.
Quantities quantities(const StudyReport& report);

}  // namespace polhode
