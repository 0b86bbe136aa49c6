// SPDX-License-Identifier: MIT
// The results of an analysis as a page of text.
#pragma once

#include "polhode/run/analysis/analysis_report.hpp"

namespace polhode::cli {

void print_analysis(const AnalysisReport& report);

}  // namespace polhode::cli
