// SPDX-License-Identifier: MIT
// Analysis of a trajectory: its frames are read once, in batches, and passed to the requested
// observables.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "polhode/base/workers.hpp"
#include "polhode/io/coordinates/frame_file.hpp"
#include "polhode/measure/conditions.hpp"
#include "polhode/measure/radial_distribution.hpp"
#include "polhode/run/analysis/observable.hpp"
#include "polhode/run/analysis/step_errors.hpp"
#include "polhode/run/callbacks.hpp"

namespace polhode {

/// Default cutoff of g(r), unless half of the shortest edge is shorter [nm].
inline constexpr double default_rdf_cutoff = 1;

struct AnalysisSettings {
  /// Requested observables; an observable that the frames do not allow is an error. Empty: all that
  /// the frames allow.
  std::set<std::string> what;
  double from = 0;                 ///< earlier frames are skipped [ps]
  std::optional<double> interval;  ///< time between frames, overrides their times [ps]
  double window = 10;              ///< largest lag of correlation functions [ps]
  std::vector<SitePair> pairs;     ///< empty: `site_pairs`
  std::optional<double> cutoff;    ///< of g(r); default: `default_rdf_cutoff`, at most half of the
                                   ///< shortest edge
  double bin = 0.002;              ///< bin width of g(r) [nm]
  std::optional<StepErrorSettings>
      step_errors;  ///< source of time-step errors; empty: no bias is computed
};

/// The frames that were read, and the observables that were requested.
struct Analysis {
  Topology topology;
  std::size_t frames = 0;
  double first = 0, last = 0;  ///< times [ps]
  double interval = 0;         ///< time between frames; 0 if no observable needed it [ps]
  Box box;                     ///< box of the first frame
  bool has_velocities = false;
  double deviation = 0;            ///< largest distance of atoms from the sites of the rigid models
                                   ///< [nm]
  bool stopped = false;            ///< whether it was stopped before the end of the file
  std::vector<std::string> notes;  ///< observables that were skipped, and warnings

  std::optional<Conditions> conditions;  ///< computed in every analysis
  std::vector<std::shared_ptr<Observable>> observables;

  /// Number of frames with a known time-step error, and the means that are fixed.
  std::size_t frames_with_step_error = 0;
  std::optional<FixedMeans> fixed;

  /// The interval, or the mean time between frames; 0 if they have no times [ps].
  double mean_interval() const;
};

/// Reads all frames. Memory holds one batch of frames, one per thread, and the windows of the
/// correlation functions. Bodies are fitted to several frames in parallel; observables are computed
/// in parallel over bodies.
/// @throws Error  if frames do not fit the topology, or do not allow what was requested
Analysis analyze(FrameReader& reader, Topology topology, const AnalysisSettings& settings,
                 const Callbacks& callbacks = {}, Workers& workers = Workers::serial());

/// The names of observables, as used in options.
const std::vector<std::string>& observable_names();

/// The name of an observable, as it is.
/// @throws Error  if there is none
std::string observable(const std::string& name);

}  // namespace polhode
