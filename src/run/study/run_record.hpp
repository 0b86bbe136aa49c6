// SPDX-License-Identifier: MIT
// Records of runs: each run is saved when it ends, so that an interrupted study can be resumed.
#pragma once

#include <fstream>
#include <iosfwd>
#include <string>
#include <vector>

#include "polhode/io/files/table_file.hpp"

namespace polhode {

/// The finished runs of a study, one line each, appended as they end.
/// @tparam Run  StudyRun or CanonicalRun
template <class Run>
class RunRecord {
 public:
  /// Reads the record if it exists and belongs to the same study, otherwise creates one.
  /// @throws Error  as read(), unless `force` is set
  RunRecord(const std::string& path, const Provenance& provenance, bool force);
  const std::vector<Run>& known() const { return known_; }
  void add(const Run& run);

  /// The runs in a record. An incomplete last line, left by an interruption, is ignored and its run
  /// repeated. Numbers are empty where a run has none, and ignored if it blew up.
  /// @param path        for errors
  /// @param provenance  of the study that is being resumed; null: any study
  /// @throws Error  with the line, if the record belongs to another study, or another line is
  ///                incomplete or contains impossible values
  static std::vector<Run> read(std::istream& in, const std::string& path,
                               const Provenance* provenance = nullptr);

 private:
  std::string path_;
  std::vector<Run> known_;
  std::ofstream out_;
};

}  // namespace polhode
