// SPDX-License-Identifier: MIT
// An analysis of a trajectory file with its outputs: tables, figures and JSON.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "polhode/run/outputs.hpp"
#include "run/analysis/analysis_summary.hpp"

namespace polhode {

/// The input of an analysis, and where the curves are written.
struct AnalysisInput {
  std::string trajectory;  ///< path of the trajectory; the extension selects the format
  std::string names;       ///< coordinate file with the names of the atoms; empty if not needed
  Topology topology;       ///< molecules of the frames
  std::string origin;      ///< text that gave the topology, for the headers of the outputs
  std::uint64_t seed = 0;  ///< seed of the run, for the headers of the outputs
  AnalysisSettings settings;
  SummarySettings summary;
  std::string prefix = "polhode-analysis";  ///< prefix of the output files
  std::string plot = "svg";                 ///< format of figures: "svg", "png" or "none"
};

struct AnalysisReport {
  Analysis analysis;
  AnalysisSummary summary;
  std::vector<std::string> files;  ///< paths of the files that were written
};

/// Reads the frames, computes the observables, and writes their curves. After an interruption, the
/// frames read so far are analyzed.
/// @throws Error  before anything is computed, if outputs exist; if the frames do not fit the
///                topology, or do not allow the requested observables
AnalysisReport run_analysis(const AnalysisInput& input, const OutputOptions& options = {},
                            const Callbacks& callbacks = {}, Workers& workers = Workers::serial());

/// The results of an analysis as a list.
Quantities analysis_quantities(const AnalysisReport& report);

/// The results of an analysis as lines of text, without files.
std::string analysis_text(const AnalysisReport& report);

/// The report of an analysis as JSON. Names contain units, as in "interval_ps"; unknown values are
/// null.
std::string analysis_json(const AnalysisReport& report);

}  // namespace polhode
