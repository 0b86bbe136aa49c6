// SPDX-License-Identifier: MIT
// The parts of a study, from settings to files, that do not depend on the measured quantities.
#pragma once

#include <fmt/core.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "io/figures/plot.hpp"
#include "io/files/draft.hpp"
#include "io/files/write_file.hpp"
#include "polhode/base/error.hpp"
#include "polhode/run/outputs.hpp"
#include "run/output_files.hpp"
#include "run/quantity_lists.hpp"
#include "run/simulation/system/system_notes.hpp"
#include "run/study/run_record.hpp"
#include "run/study/study_report.hpp"

namespace polhode {

/// Performs a study of any kind. A kind of study has types Run, with its initial configuration
/// `start`, and Report, and
///     title                                      what it is called in notes
///     identity(config, system)                   of its record
///     perform(config, known, keep, callbacks, workers)
///     records_of(report), figure_of(report, csv)
/// and, as an object with the settings `config`,
///     points()                                   their number
///     check(system)                              throws Error
///     note(callbacks)                            before the notes on molecules and forces
///     report(system, runs)
template <class Study>
class StudyJob {
 public:
  using Run = typename Study::Run;
  using Report = typename Study::Report;

  /// @param prefix  prefix of the output files
  /// @throws Error  if a setting is invalid
  StudyJob(const Study& study, const std::string& prefix, const OutputOptions& options,
           const Callbacks& callbacks)
      : study_(study),
        files_(checked(prefix)),
        system_(build_system(study.config)),
        existing_(options.existing),
        callbacks_(callbacks),
        made_(provenance(options.command, Study::identity(study.config, system_),
                         study.config.system.seed)) {
    study_.check(system_);
  }

  /// Performs the study, or makes the report of an existing record.
  /// @param record  path of the existing record; empty to perform the study
  Report perform(const std::string& record, Workers& workers) const {
    return record.empty() ? run(workers) : from(record);
  }

 private:
  /// Performs the runs that are not yet in the record.
  Report run(Workers& workers) const {
    const OutputLock lock(files_.prefix + "-study.lock", callbacks_);
    // Files of a resumed study are overwritten, but files of another study are not.
    if (!std::filesystem::exists(files_.runs)) check_outputs(files_.all(), existing_);
    remove_drafts(files_.all());
    RunRecord<Run> record(files_.runs, made_, existing_ == ExistingFiles::replace);
    std::vector<Run> runs = record.known();
    note_begin(workers.threads());
    if (!runs.empty()) note_known(runs, files_.runs);
    const auto keep = [&](const Run& run) {
      record.add(run);
      runs.push_back(run);
    };
    Study::perform(study_.config, record.known(), keep, callbacks_, workers);
    Report report = report_of(runs);
    report.files = report.points.empty() ? std::vector{files_.runs} : files_.all();
    report.interrupted = callbacks_.stopped();
    return report;
  }

  /// Makes the report of an existing record.
  Report from(const std::string& record) const {
    std::ifstream in(record, std::ios::binary);
    if (!in) throw Error(fmt::format("there is no study record '{}'; check the name", record));
    const std::vector<Run> runs = RunRecord<Run>::read(in, record);
    check_outputs(files_.tables(), existing_);
    note_known(runs, record);
    Report report = report_of(runs);
    if (!report.points.empty()) report.files = files_.tables();
    return report;
  }

  static const std::string& checked(const std::string& prefix) {
    check_prefix(prefix, StudyFiles(prefix).all());
    return prefix;
  }

  void note_begin(int threads) const {
    const StudySettings& settings = study_.config.study;
    callbacks_.note(fmt::format(
        "polhode {}: {} of {} molecules, {} points of {} runs of {:g} ps, instruction set {}, "
        "threads {}",
        made_.version, Study::title, system_.topology.size(), study_.points(), settings.runs,
        settings.length, made_.instruction_set, threads));
    study_.note(callbacks_);
    note_molecules(system_, callbacks_);
    note_forces(system_, callbacks_);
  }

  void note_known(const std::vector<Run>& runs, const std::string& path) const {
    callbacks_.note(fmt::format("{} runs were read from {}", runs.size(), path));
  }

  /// Makes the report of the selected runs and writes its files. All points use the same initial
  /// configurations, even if the record has more, so that the points can be compared.
  Report report_of(const std::vector<Run>& runs) const {
    std::vector<Run> counted;
    for (const Run& run : runs)
      if (run.start < study_.config.study.runs) counted.push_back(run);
    if (counted.size() < runs.size())
      callbacks_.note(
          fmt::format("the tables use the first {} initial configurations; {} runs from later "
                      "configurations are left out",
                      study_.config.study.runs, runs.size() - counted.size()));
    Report report = study_.report(system_, counted);
    // Without a complete run no tables are written, and existing files remain unchanged.
    if (!report.points.empty()) write(report);
    return report;
  }

  void write(const Report& report) const {
    write_file(files_.points, [&](std::ostream& out) {
      write_csv(out, table_of(Study::records_of(report)), made_);
    });
    write_file(files_.json,
               [&](std::ostream& out) { out << json_text(quantities(report)) << '\n'; });
    pass_messages(callbacks_, [&](std::ostream& warnings) {
      for (const char* format : {"svg", "png"})
        draw_figure(Study::figure_of(report, files_.points), format, warnings);
    });
  }

  const Study& study_;
  StudyFiles files_;
  System system_;
  ExistingFiles existing_;
  const Callbacks& callbacks_;
  Provenance made_;
};

}  // namespace polhode
