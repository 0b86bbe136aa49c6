// SPDX-License-Identifier: MIT
// Records of runs: each run is appended when it ends, so that an interrupted study can be resumed.
#pragma once

#include <fstream>
#include <iosfwd>
#include <string>
#include <vector>

#include "polhode/io/files/table_file.hpp"
#include "polhode/run/canonical/canonical_study.hpp"
#include "polhode/run/study/study.hpp"

namespace polhode {

/// The record of the finished runs of a study. Each run is appended as a line when it ends.
/// @tparam Run  type of the runs: StudyRun or CanonicalRun
template <class Run>
class RunRecord {
 public:
  /// Reads the record if it exists and belongs to the same study, and creates a new record
  /// otherwise.
  /// @throws Error  under the same conditions as read(), unless `force` is set
  RunRecord(const std::string& path, const Provenance& provenance, bool force);
  const std::vector<Run>& known() const { return known_; }
  void add(const Run& run);

  /// Reads the runs in a record. An incomplete last line, left by an interruption, is ignored, and
  /// its run is repeated. A field is empty if the run does not have the number. The numbers of a
  /// run that blew up are ignored.
  /// @param path        path of the record, for error messages
  /// @param provenance  provenance of the study that is being resumed; null for any study
  /// @throws Error  with the line, if the record belongs to another study, or another line is
  ///                incomplete or contains impossible values
  static std::vector<Run> read(std::istream& in, const std::string& path,
                               const Provenance* provenance = nullptr);

 private:
  std::string path_;
  std::vector<Run> known_;
  std::ofstream out_;
};

/// The record of a study of energy conservation; records of any version of the program can be read.
using StudyRecord = RunRecord<StudyRun>;
/// The record of a canonical study.
using CanonicalRecord = RunRecord<CanonicalRun>;

/// A text with everything that determines the runs of a study, so that records of a different study
/// are not used.
std::string study_identity(const Config& config, const System& system);
std::string canonical_identity(const Config& config, const System& system);

}  // namespace polhode
