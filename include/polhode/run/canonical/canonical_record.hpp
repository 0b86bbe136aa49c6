// SPDX-License-Identifier: MIT
// The record of a canonical study: each run is saved when it ends, so that an interrupted study can
// be resumed.
#pragma once

#include <fstream>
#include <iosfwd>
#include <string>
#include <vector>

#include "polhode/io/table_file.hpp"
#include "polhode/run/canonical/canonical_study.hpp"

namespace polhode {

/// Everything that determines the runs of a canonical study, as text: records of a different study
/// are not reused.
std::string canonical_identity(const Config& config, const System& system);

/// The runs in a record. An incomplete last line, left by an interruption, is ignored and its run
/// repeated. Numbers are empty where a run has none.
/// @param provenance  of the study that is being resumed; null: any study
/// @throws Error  with the line, if the record belongs to another study, or another line is
///                incomplete or contains impossible values
std::vector<CanonicalRun> read_canonical_record(std::istream& in, const std::string& path,
                                                const Provenance* provenance = nullptr);

/// The finished runs, one line each, appended as they end.
class CanonicalRecord {
 public:
  /// Reads the record if it exists and belongs to the same study, otherwise creates one.
  /// @throws Error  as read_canonical_record(), unless `force` is set
  CanonicalRecord(const std::string& path, const Provenance& provenance, bool force);
  const std::vector<CanonicalRun>& known() const { return known_; }
  void add(const CanonicalRun& run);

 private:
  std::string path_;
  std::vector<CanonicalRun> known_;
  std::ofstream out_;
};

}  // namespace polhode
