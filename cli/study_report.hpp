// SPDX-License-Identifier: MIT
// Results of a study: tables, a figure, and a page of text.
#pragma once

#include <string>
#include <vector>

#include "polhode/io/table_file.hpp"
#include "polhode/run/simulation/equipartition.hpp"
#include "polhode/run/study/claims.hpp"

namespace polhode::cli {

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
  /// All files except the record.
  std::vector<std::string> tables() const { return {points, json, script, svg, png}; }
  std::vector<std::string> all() const { return {points, runs, json, script, svg, png}; }
};

struct StudyReport {
  Config config;
  std::vector<EfficiencyPoint> points;
  std::vector<Curve> curves;
  std::vector<Guideline> guidelines;
  std::vector<Claim> claims;
  std::vector<EquipartitionFit> equipartition;

  StudyReport(const Config& config, const std::vector<EfficiencyPoint>& points);
};

/// "for R = 0.5 % use SCHEME at H fs: N force evaluations per ps, X times fewer than velocity
/// Verlet"
std::string advice(const StudyReport& report, double ratio);

void write_study(const StudyFiles& files, const StudyReport& report, const Provenance& provenance);
std::string study_json(const StudyReport& report);
/// @param written  files to be named at the end
void print_study(const StudyReport& report, const std::vector<std::string>& written);

}  // namespace polhode::cli
