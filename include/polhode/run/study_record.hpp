// SPDX-License-Identifier: MIT
// The record of a study: its runs as they end, so that an interrupted study can go on.
#pragma once

#include <fstream>
#include <iosfwd>
#include <string>
#include <vector>

#include "polhode/io/table_file.hpp"
#include "polhode/run/study.hpp"
#include "polhode/run/system.hpp"

namespace polhode {

/// Everything that decides what a run of a study is, as text: a record of another one is not
/// reused.
std::string study_identity(const Config& config, const System& system);

/// The runs that a record holds. A last line without its end was cut short and is left out: its run
/// is done again. A run's numbers are finite, and void where it blew up.
/// @param path        for errors
/// @param provenance  of the study that goes on
/// @throws Error  with the line, if the record is of another study, or another line is not whole,
///                or holds what no run gives
std::vector<StudyRun> read_study_record(std::istream& in, const std::string& path,
                                        const Provenance& provenance);

/// The runs of a record as they are, whichever study and version of the program it is of.
/// @throws Error  as read_study_record(), but for the study
std::vector<StudyRun> read_any_study_record(std::istream& in, const std::string& path);

/// The runs that are done, one line each, appended as they end.
class StudyRecord {
 public:
  /// Reads the record if it is there and belongs to the same study, else begins one.
  /// @throws Error  as read_study_record(), unless `force` is given
  StudyRecord(const std::string& path, const Provenance& provenance, bool force);
  const std::vector<StudyRun>& known() const { return known_; }
  void add(const StudyRun& run);

 private:
  std::string path_;
  std::vector<StudyRun> known_;
  std::ofstream out_;
};

}  // namespace polhode
