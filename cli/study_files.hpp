// SPDX-License-Identifier: MIT
// What a study leaves: a record that it can go on from, tables, a figure, and a page of text.
#pragma once

#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "polhode/io/table_file.hpp"
#include "polhode/run/guideline.hpp"
#include "polhode/run/system.hpp"

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
  std::vector<std::string> all() const { return {points, runs, json, script, svg, png}; }
};

/// Everything that decides what a run of a study is, as text: a record of another one is not
/// reused.
std::string study_identity(const Config& config, const System& system);

/// The runs that are done, one line each, appended as they end.
class StudyRecord {
 public:
  /// Reads the record if it is there and belongs to the same study, else begins one.
  /// @throws Error  if it belongs to another study and `force` is not given
  StudyRecord(const std::string& path, const Provenance& provenance, bool force);
  const std::vector<StudyRun>& known() const { return known_; }
  void add(const StudyRun& run);

 private:
  std::string path_;
  std::vector<StudyRun> known_;
  std::ofstream out_;
};

/// A claim of the paper, with our number.
struct Claim {
  std::string text;
  std::optional<Estimate> value;
  std::string reproduced;  ///< "reproduced", "not reproduced" or "not decided by these data"
};

struct StudyReport {
  Config config;
  std::vector<EfficiencyPoint> points;
  std::vector<Curve> curves;
  std::vector<Guideline> guidelines;
  std::vector<Claim> claims;

  StudyReport(const Config& config, const std::vector<EfficiencyPoint>& points);
};

/// "for R = 0.5 % use SCHEME at H fs: N force evaluations per ps, X times fewer than velocity
/// Verlet"
std::string advice(const StudyReport& report, double ratio);

void write_study(const StudyFiles& files, const StudyReport& report, const Provenance& provenance);
std::string study_json(const StudyReport& report);
void print_study(const StudyReport& report, const StudyFiles& files);

}  // namespace polhode::cli
