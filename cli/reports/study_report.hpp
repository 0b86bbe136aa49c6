// SPDX-License-Identifier: MIT
// The result of a study, of either kind, as text or JSON.
#pragma once

#include <fmt/core.h>

#include <string>

#include "../terminal/streams.hpp"
#include "run/canonical/canonical_report.hpp"
#include "run/study/study_report.hpp"

namespace polhode::cli {

/// Prints the tables and what they show.
void print_study(const StudyReport& report);
void print_study(const CanonicalReport& report);

/// Prints the report, no tables if no run ended, and how an interrupted study resumes.
/// @param record  file of the runs so far
/// @return  the exit code
template <class Report>
int finish_study(const Report& report, const std::string& record, bool json) {
  if (json)
    fmt::print("{}\n", study_json(report));
  else if (!report.points.empty())
    print_study(report);
  if (!report.interrupted) return 0;
  log("interrupted{}; the same command resumes from {}\n",
      report.points.empty() ? " before the first run ended" : "", record);
  return 130;
}

}  // namespace polhode::cli
