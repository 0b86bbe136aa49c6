// SPDX-License-Identifier: MIT
// The curves of an analysis as tables with their figures.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "polhode/io/plot.hpp"
#include "polhode/io/table_file.hpp"
#include "polhode/run/analysis/analysis_summary.hpp"

namespace polhode {

/// A table with its figure; no figure is drawn without panels.
struct AnalysisFile {
  std::string name;  ///< between the prefix and the extension: "rdf"
  Table table;
  CurvesFigure figure;
};

/// The names of the files of each observable, in the order of `analysis_files`.
std::vector<std::string> file_names(const std::set<Observable>& what);

/// Curves of all observables that were computed.
std::vector<AnalysisFile> analysis_files(Analysis& analysis, const AnalysisSummary& summary,
                                         Workers& workers);

}  // namespace polhode
