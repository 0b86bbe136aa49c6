// SPDX-License-Identifier: MIT
// The result of a study as text or JSON.
#pragma once

#include <string>

#include "polhode/run/study/study_report.hpp"

namespace polhode::cli {

/// Prints the tables, none if no run ended, and how an interrupted study resumes.
/// @param record  file of the runs so far
/// @return  the exit code
int print_study(const StudyReport& report, const std::string& record, bool json);

}  // namespace polhode::cli
