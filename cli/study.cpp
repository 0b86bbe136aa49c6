// SPDX-License-Identifier: MIT
// polhode study [FILE]: accuracy against cost for each scheme, the figure of the paper.
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "interrupt.hpp"
#include "option_values.hpp"
#include "polhode/base/error.hpp"
#include "polhode/base/instruction_set.hpp"
#include "polhode/base/threads.hpp"
#include "polhode/io/file_lock.hpp"
#include "polhode/io/output_units.hpp"
#include "polhode/io/plot.hpp"
#include "polhode/io/table_file.hpp"
#include "polhode/run/simulation/near_forces.hpp"
#include "polhode/run/simulation/system.hpp"
#include "polhode/run/study/guideline.hpp"
#include "polhode/run/study/study_record.hpp"
#include "progress.hpp"
#include "streams.hpp"
#include "study_report.hpp"
#include "system_notes.hpp"
#include "verbs.hpp"

namespace polhode::cli {
namespace {

struct Options {
  std::string file, output = "study", length, decorrelate, threads, precision, configurational,
                    from_record;
  std::vector<std::string> schemes, steps;
  int runs = 0;
  bool quick = false, force = false, json = false;
};

/// A reduced version, reported as such: fewer and shorter runs, fewer steps.
void make_quick(StudySettings& study) {
  study.runs = 4;
  study.length = 8;
  study.decorrelate = 2;
  study.coarse = true;
}

Config make_config(const Options& o) {
  Config config = o.file.empty() ? default_config() : read_config(o.file);
  if (!o.precision.empty()) set_precision(config, precision_option(o.precision));
  StudySettings& study = config.study;
  if (o.quick) make_quick(study);
  if (!o.schemes.empty()) study.schemes = o.schemes;
  for (const std::string& scheme : o.schemes) scheme_option(scheme, "--schemes");
  if (!o.steps.empty()) {
    study.steps.clear();
    for (const std::string& step : o.steps) study.steps.push_back(positive_time(step, "--steps"));
    std::sort(study.steps.begin(), study.steps.end());
  }
  if (o.runs != 0) study.runs = o.runs;
  if (!o.length.empty()) study.length = positive_time(o.length, "--length");
  if (!o.decorrelate.empty()) study.decorrelate = positive_time(o.decorrelate, "--decorrelate");
  if (!o.configurational.empty())
    study.configurational_sample = positive_time(o.configurational, "--configurational-sample");
  return config;
}

/// Writes and prints the results of the runs that count.
void report(const Options& o, Config config, const System& system,
            const std::vector<StudyPoint>& points, const std::vector<StudyRun>& runs,
            const StudyFiles& files, const Provenance& provenance) {
  const std::vector<StudyRun> counted = runs_of_starts(runs, config.study.runs);
  if (counted.size() < runs.size())
    log("the tables use the first {} initial configurations; {} runs from later ones are left "
        "out\n",
        config.study.runs, runs.size() - counted.size());
  config.forces.mixing = system.forces.mixing;  // known after the topology file is read
  const StudyReport report(config, efficiency_points(points, counted));
  write_study(files, report, provenance);
  if (o.json)
    fmt::print("{}\n", study_json(report));
  else
    print_study(report, o.from_record.empty() ? files.all() : files.tables());
}

/// Tables and figure from an existing record, without new runs.
int study_of_record(const Options& o) {
  const Config config = make_config(o);
  std::ifstream in(o.from_record, std::ios::binary);
  if (!in) throw Error(fmt::format("there is no file '{}'", o.from_record), "--from-record");
  const std::vector<StudyRun> runs = read_any_study_record(in, o.from_record);
  const StudyFiles files(o.output);
  for (const std::string& file : files.tables()) refuse_existing(file, o.force);
  const System system = build_system(config);
  const Provenance provenance{
      POLHODE_VERSION,
      typed_command("polhode study", {{"", o.file}, {"--from-record", o.from_record}}),
      study_identity(config, system), name(current_instruction_set()), config.system.seed};
  report(o, config, system, study_points(config.study), runs, files, provenance);
  return 0;
}

int study(const Options& o) {
  if (!o.from_record.empty()) return study_of_record(o);
  const Config config = make_config(o);
  const std::vector<StudyPoint> points = study_points(config.study);
  for (const StudyPoint& point : points)
    if (config.study.length < 10 * point.step)
      throw Error(
          fmt::format("the study's length of {:g} fs is less than ten steps of {:g} fs, "
                      "too few for R; take longer runs, or leave out long steps",
                      config.study.length * units::fs_per_ps, point.step * units::fs_per_ps),
          config.source);
  Workers workers(requested_threads(o.threads));
  const System system = build_system(config);
  for (const StudyPoint& point : points) check_near(system.forces, point.scheme, config.source);

  const StudyFiles files(o.output);
  const FileLock lock(files.prefix + "-study.lock");
  note_lock(lock);
  // Results of a resumed study are overwritten; those of another one are not.
  if (!std::filesystem::exists(files.runs))
    for (const std::string& file : files.all()) refuse_existing(file, o.force);
  const Provenance provenance{POLHODE_VERSION, typed_command("polhode study", {{"", o.file}}),
                              study_identity(config, system), name(current_instruction_set()),
                              config.system.seed};
  StudyRecord record(files.runs, provenance, o.force);
  std::vector<StudyRun> runs = record.known();
  log("polhode {}: study of {} molecules, {} points of {} runs of {:g} ps, instruction set {}, "
      "threads {}\n",
      POLHODE_VERSION, system.topology.size(), points.size(), config.study.runs,
      config.study.length, provenance.instruction_set, workers.threads());
  note_molecules(system);
  note_forces(system);
  if (!runs.empty()) log("{} runs are read from {}\n", runs.size(), files.runs);

  catch_interrupts();
  {
    Progress progress("study");
    run_study(
        config, runs,
        [&](const StudyRun& run) {
          record.add(run);
          runs.push_back(run);
        },
        {[&](double done, const std::string& what) { progress.show(done, what); }, interrupted},
        workers);
  }

  report(o, config, system, points, runs, files, provenance);
  if (interrupted()) {
    log("interrupted; the same command resumes from {}\n", files.runs);
    return 130;
  }
  return 0;
}

}  // namespace

Action study_verb(CLI::App& app) {
  auto o = std::make_shared<Options>();
  app.add_option("FILE", o->file, "run file (TOML); default: 512 TIP4P waters");
  app.add_flag("--quick", o->quick, "a small version: about three minutes on two cores");
  app.add_option("--schemes", o->schemes, "names, or stages as text");
  app.add_option("--steps", o->steps, "steps for every scheme: \"2 fs\" \"4 fs\"");
  app.add_option("--runs", o->runs, "independent runs at each point")->check(CLI::Range(2, 1000));
  app.add_option("--length", o->length, "of each run: \"15 ps\"");
  app.add_option("--decorrelate", o->decorrelate,
                 "equilibration of each initial configuration: \"10 ps\"");
  app.add_option(
      "--configurational-sample", o->configurational,
      "time between samples of the configurational temperature: \"20 fs\"; default: none");
  app.add_option("--from-record", o->from_record,
                 "make tables and figure from this record, of any version, without runs");
  app.add_option("--output", o->output, "prefix of the output files")->capture_default_str();
  app.add_option("--precision", o->precision,
                 "precision of pair interactions, double or mixed; default: the run file's");
  app.add_option("--threads", o->threads,
                 "number of simultaneous runs; default: one for each available core");
  app.add_flag("--force", o->force, "start over if results of another study exist");
  app.add_flag("--json", o->json, "print the results as JSON");
  return [o] { return study(*o); };
}

}  // namespace polhode::cli
