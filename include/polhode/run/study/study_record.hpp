// SPDX-License-Identifier: MIT
// The record of a study: each run is saved when it ends, so that an interrupted study can be
// resumed.
#pragma once

#include <fstream>
#include <iosfwd>
#include <string>
#include <vector>

#include "polhode/io/table_file.hpp"
#include "polhode/run/simulation/system.hpp"
#include "polhode/run/study/study.hpp"

namespace polhode {

/// Everything that determines the runs of a study, as text: records of a different study are not
/// reused.
std::string study_identity(const Config& config, const System& system);

/// The runs in a record. An incomplete last line, left by an interruption, is ignored and its run
/// repeated. The numbers of a run are finite, and empty if it blew up.
/// @param path        for errors
/// @param provenance  of the study that is being resumed
/// @throws Error  with the line, if the record belongs to another study, or another line is
///                incomplete or contains impossible values
std::vector<StudyRun> read_study_record(std::istream& in, const std::string& path,
                                        const Provenance& provenance);

/// All runs in a record of any study and any version of the program.
/// @throws Error  as read_study_record(), but for any study
std::vector<StudyRun> read_any_study_record(std::istream& in, const std::string& path);

/// The finished runs, one line each, appended as they end.
class StudyRecord {
 public:
  /// Reads the record if it exists and belongs to the same study, otherwise creates one.
  /// @throws Error  as read_study_record(), unless `force` is set
  StudyRecord(const std::string& path, const Provenance& provenance, bool force);
  const std::vector<StudyRun>& known() const { return known_; }
  void add(const StudyRun& run);

 private:
  std::string path_;
  std::vector<StudyRun> known_;
  std::ofstream out_;
};

}  // namespace polhode
