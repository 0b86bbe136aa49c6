// SPDX-License-Identifier: MIT
// The output that verbs print when they finish.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "../options/job_options.hpp"
#include "../terminal/streams.hpp"
#include "polhode/run/quantities.hpp"
#include "polhode/run/simulation/simulation.hpp"

namespace polhode::cli {

/// Prints results as JSON, or as text that fits into the terminal.
void print_results(const Quantities& results, const ResultForm& form);
/// Prints a list of records as JSON or as a table with a title.
void print_results(const std::string& title, const std::vector<Quantities>& records, bool json);

/// Prints to standard error that a job was interrupted.
/// @param how  rest of the message, such as " before a result was found"
/// @return     exit code
int interrupted(std::string_view how);

/// Prints the results of a run. An interrupted run is reported on standard error.
/// @return  exit code
int print_run(const RunResult& result, const Simulation& simulation, const ResultForm& form);

/// Prints to standard error from which step a failed run can be resumed, if this is possible.
void note_resumable(const Simulation& simulation);

/// Prints the results of a study, and how to resume it if it was interrupted. If no run has
/// finished, no results are printed.
/// @param record  file with the runs so far
/// @return  exit code
template <class Report>
int finish_study(const Report& report, const std::string& record, const ResultForm& form) {
  if (form.json || !report.points.empty()) print_results(quantities(report), form);
  if (!report.interrupted) return 0;
  return interrupted(fmt::format("{}; the same command resumes from {}",
                                 report.points.empty() ? " before the first run ended" : "",
                                 record));
}

}  // namespace polhode::cli
