// SPDX-License-Identifier: MIT
// The results of a study as a page of text.
#pragma once

#include "polhode/run/study/study_report.hpp"

namespace polhode::cli {

void print_study(const StudyReport& report);

}  // namespace polhode::cli
