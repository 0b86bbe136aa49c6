// SPDX-License-Identifier: MIT
#include "reports.hpp"

#include <fmt/core.h>

namespace polhode::cli {
namespace {

/// What is probably wrong, each with its remedy; nothing without warnings.
void print_warnings(const std::vector<Warning>& warnings) {
  if (warnings.empty()) return;
  fmt::print("\nWARNINGS: something is probably wrong with this run\n");
  for (const Warning& w : warnings)
    fmt::print("  {:<18}  {}\n  {:<18}  -> {}\n", w.kind, w.text, "", w.remedy);
}

void print_text(const RunReport& r) {
  fmt::print("{}", run_text(r));
  if (r.guarantee && !r.guarantee->met())
    log("warning: the accuracy guarantee of [integrator] accuracy was not met: {}; give a smaller "
        "accuracy, or set the step yourself\n",
        guarantee_text(*r.guarantee));
  print_files(r.files.all());
  print_warnings(r.warnings);
}

/// The files of an interrupted run, and how to resume it.
void note_end(const RunResult& result, const std::string& checkpoint) {
  switch (result.end) {
    case RunEnd::complete:
      return;
    case RunEnd::interrupted:
      return log("interrupted after {} steps; the results so far follow, and --resume continues\n",
                 result.report->summary.steps);
    case RunEnd::interrupted_equilibrating:
      return log(
          "interrupted during the equilibration; '{}' is its checkpoint, and --resume continues\n",
          checkpoint);
    case RunEnd::interrupted_choosing_step:
      return log("interrupted while choosing the step; no file was written\n");
  }
}

std::string checkpoint_of(const Simulation& simulation) {
  return RunFileNames(simulation.config().output).checkpoints.newest;
}

}  // namespace

void print_results(const Quantities& results, bool json) {
  fmt::print("{}{}", json ? json_text(results) : text_of(results), json ? "\n" : "");
}

void print_results(const std::string& title, const std::vector<Quantities>& records, bool json) {
  if (json)
    fmt::print("{}\n", json_text(records));
  else
    print_results({{"", "", records, "", title}}, false);
}

void print_preparation(const PreparationReport& r) {
  if (!r.properties) return;
  print_results(quantities(r), false);
  print_files(r.files);
  fmt::print("next                  polhode run {}\n", r.run_file);
  print_warnings(r.properties->warnings);
}

int print_run(const RunResult& result, const Simulation& simulation, bool json) {
  note_end(result, checkpoint_of(simulation));
  if (result.report && json)
    fmt::print("{}\n", run_json(*result.report));
  else if (result.report)
    print_text(*result.report);
  return result.end == RunEnd::complete ? 0 : 130;
}

void note_resumable(const Simulation& simulation) {
  if (simulation.resumable_step())
    log("'{}' is the checkpoint of step {}, from which --resume continues\n",
        checkpoint_of(simulation), *simulation.resumable_step());
}

}  // namespace polhode::cli
