// SPDX-License-Identifier: MIT
// The record of a study: its runs as they end, so that an interrupted study can go on.
#pragma once

#include <fstream>
#include <string>
#include <vector>

#include "polhode/io/table_file.hpp"
#include "polhode/run/study.hpp"
#include "polhode/run/system.hpp"

namespace polhode {

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

}  // namespace polhode
