// SPDX-License-Identifier: MIT
// An analysis of a trajectory file with its outputs: tables, figures and JSON.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "polhode/run/outputs.hpp"
#include "run/analysis/analysis_summary.hpp"

namespace polhode {

/// What is analyzed, and where the curves are written.
struct AnalysisInput {
  std::string trajectory;  ///< file of frames, whose extension is that of its format
  std::string names;       ///< coordinate file with the names of the atoms; empty: none is needed
  Topology topology;       ///< the molecules of the frames
  std::string origin;      ///< text that the topology comes from, for the headers of the outputs
  std::uint64_t seed = 0;  ///< of the run, likewise
  AnalysisSettings settings;
  SummarySettings summary;
  std::string prefix = "polhode-analysis";  ///< of the output files
  std::string plot = "svg";                 ///< "svg", "png" or "none"
};

struct AnalysisReport {
  Analysis analysis;
  AnalysisSummary summary;
  std::vector<std::string> files;  ///< that were written
};

/// Reads the frames, computes the observables, and writes their curves. What was read before an
/// interruption is analyzed.
/// @throws Error  before anything is computed, if outputs exist; if the frames do not fit the
///                topology, or do not allow what was requested
AnalysisReport run_analysis(const AnalysisInput& input, const OutputOptions& options = {},
                            const Callbacks& callbacks = {}, Workers& workers = Workers::serial());

/// The results as a list.
Quantities analysis_quantities(const AnalysisReport& report);

/// The results as lines of text, without files.
std::string analysis_text(const AnalysisReport& report);

/// The report as JSON. Names contain units, as in "interval_ps"; unknown values are null.
std::string analysis_json(const AnalysisReport& report);

}  // namespace polhode
