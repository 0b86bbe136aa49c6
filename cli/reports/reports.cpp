// SPDX-License-Identifier: MIT
#include "reports.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "../terminal/terminal.hpp"
#include "run/quantity_lists.hpp"

namespace polhode::cli {
namespace {

void print_report(const RunReport& r, const ResultForm& form) {
  if (form.json) return fmt::print("{}\n", run_json(r));
  if (r.guarantee && !r.guarantee->met())
    log("warning: the run does not meet its accuracy guarantee: {}; set accuracy in [integrator] "
        "to a smaller bound, or set the step yourself\n",
        guarantee_text(*r.guarantee));
  print_results(run_quantities(r), form);
}

/// Prints the files of an interrupted run, and how to resume it.
void note_end(const RunResult& result, const std::string& checkpoint) {
  switch (result.end) {
    case RunEnd::complete:
      return;
    case RunEnd::interrupted:
      return log(
          "interrupted after {} steps; the results so far follow, and --resume continues the run\n",
          result.report->summary.steps);
    case RunEnd::interrupted_equilibrating:
      return log(
          "interrupted during the equilibration; --resume continues the run from the checkpoint "
          "'{}'\n",
          checkpoint);
    case RunEnd::interrupted_choosing_step:
      return log("interrupted while choosing the step; no file was written\n");
  }
}

std::string checkpoint_of(const Simulation& simulation) {
  return RunFileNames(simulation.config().output).checkpoints.newest;
}

}  // namespace

void print_results(const Quantities& results, const ResultForm& form) {
  if (form.json) return fmt::print("{}\n", json_text(results));
  const std::vector<TextRow> rows = text_rows(results);
  const bool tables =
      std::any_of(rows.begin(), rows.end(), [](const TextRow& row) { return !row.table.empty(); });
  if (form.verbose && tables) return fmt::print("{}", text_of(results));  // tables are not wrapped
  if (!form.verbose &&
      std::any_of(results.begin(), results.end(), [](const Quantity& q) { return q.detail; }))
    log("--verbose also prints tables and other details\n");
  print_fitted(text_of(results, form.verbose));
}

void print_results(const std::string& title, const std::vector<Quantities>& records, bool json) {
  if (json)
    fmt::print("{}\n", json_text(records));
  else
    print_results({{"", "", records, "", title}}, {});
}

int interrupted(std::string_view how) {
  log("interrupted{}\n", how);
  return 130;
}

int print_run(const RunResult& result, const Simulation& simulation, const ResultForm& form) {
  note_end(result, checkpoint_of(simulation));
  if (result.report) print_report(*result.report, form);
  return result.end == RunEnd::complete ? 0 : 130;
}

void note_resumable(const Simulation& simulation) {
  if (simulation.resumable_step())
    log("'{}' is the checkpoint of step {}; --resume continues the run from this step\n",
        checkpoint_of(simulation), *simulation.resumable_step());
}

}  // namespace polhode::cli
