// SPDX-License-Identifier: MIT
// Observables that an analysis measures along a trajectory. A new observable needs a source file
// and an entry in the list of src/run/analysis/observables.cpp.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "polhode/base/workers.hpp"
#include "polhode/io/figures/curves_figure.hpp"
#include "polhode/io/files/table_file.hpp"
#include "polhode/measure/step_response.hpp"
#include "polhode/model/state.hpp"
#include "polhode/run/quantities.hpp"

namespace polhode {

struct Analysis;
struct AnalysisSettings;
struct SummarySettings;

/// An output table with its figure. A figure without panels is not drawn.
struct AnalysisFile {
  std::string name;  ///< part of the file name after the prefix, such as "rdf"
  Table table;
  CurvesFigure figure;
};

/// The data that are known once the first frames have been read.
struct FirstFrames {
  const Analysis& analysis;  ///< topology and box, and whether frames have velocities
  const AnalysisSettings& settings;
  std::size_t lags = 0;  ///< number of time lags of correlation functions of evenly spaced frames
};

/// The data that are known after the last frame.
struct AllFrames {
  const Analysis& analysis;
  const SummarySettings& settings;
  std::optional<double> temperature;  ///< temperature [K]
  Workers& workers;
  std::vector<std::string>& notes;  ///< receives notes on results that could not be computed
};

/// The results of an observable. Each of these lists may be empty.
struct ObservableResults {
  Quantities quantities;          ///< quantities of the whole trajectory
  std::vector<Quantities> parts;  ///< quantities of each kind of molecule
  std::vector<AnalysisFile> files;
};

/// A quantity that is measured along a trajectory.
class Observable {
 public:
  virtual ~Observable() = default;
  /// Adds the next frame.
  /// @param error  time-step error of this state; empty if it is not known
  virtual void add(const State& state, const std::optional<StepError>& error, Workers& workers) = 0;
  virtual ObservableResults results(const AllFrames& frames) = 0;
};

/// An entry in the list of observables.
struct ObservableKind {
  std::string name;                ///< name in the option `--what`
  std::vector<std::string> files;  ///< names of the files that the observable may write
  bool correlates_times = false;   ///< whether frames must be evenly spaced
  /// Returns the reason why the frames do not allow this observable; empty if they allow it.
  std::function<std::string(const FirstFrames&)> why_not;
  std::function<std::unique_ptr<Observable>(const FirstFrames&)> begin;
  bool needs_velocities = false;  ///< whether every frame must have velocities
};

/// All observables, in the order of their results.
const std::vector<ObservableKind>& observables();

}  // namespace polhode
