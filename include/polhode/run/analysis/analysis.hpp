// SPDX-License-Identifier: MIT
// Analysis of a trajectory. The frames are read once, in batches, and passed to the requested
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

/// Default cutoff of g(r), unless half of the shortest box edge is shorter [nm].
inline constexpr double default_rdf_cutoff = 1;
/// Default of the largest lag of correlation functions [ps].
inline constexpr double default_window = 10;

struct AnalysisSettings {
  /// Names of the requested observables. A requested observable that the frames do not allow is an
  /// error. If empty, all observables that the frames allow are computed.
  std::set<std::string> what;
  double from = 0;                 ///< first time to analyze; earlier frames are skipped [ps]
  std::optional<double> interval;  ///< time between frames, instead of the times in the file [ps]
  std::optional<double> window;    ///< largest lag of correlation functions [ps]; default:
                                   ///< `default_window`
  std::vector<SitePair> pairs;     ///< pairs of sites for g(r); if empty, all pairs of site_pairs()
  std::optional<double> cutoff;    ///< cutoff of g(r) [nm]; default: `default_rdf_cutoff`, at most
                                   ///< half of the shortest edge
  double bin = 0.002;              ///< bin width of g(r) [nm]
  std::optional<StepErrorSettings>
      step_errors;  ///< source of time-step errors; empty: no time-step bias is computed
};

/// The results of an analysis: the frames that were read, and the observables that were computed.
struct Analysis {
  Topology topology;
  std::size_t frames = 0;
  double first = 0, last = 0;  ///< times of the first and last frames [ps]
  double interval = 0;  ///< time between frames [ps]; 0 if no observable needs evenly spaced frames
  Box box;              ///< box of the first frame
  bool has_velocities = false;
  double deviation = 0;            ///< largest distance of atoms from their rigid models [nm]
  bool stopped = false;            ///< whether the analysis was stopped before the end of the file
  std::vector<std::string> notes;  ///< notes on skipped observables, and warnings

  std::optional<Conditions> conditions;  ///< averages that are computed in every analysis
  std::vector<std::shared_ptr<Observable>> observables;

  /// Number of frames with a known time-step error, and the means that the ensemble fixes.
  std::size_t frames_with_step_error = 0;
  std::optional<FixedMeans> fixed;

  /// The time between frames, or the mean if this time varies [ps]; 0 if frames have no times.
  double mean_interval() const;
};

/// Reads all frames of a trajectory and computes observables. The memory holds one frame per thread
/// (a batch), and the windows of the correlation functions. Bodies are fitted to the frames of a
/// batch in parallel. Observables are computed in parallel over bodies.
/// @throws Error  if frames do not fit the topology, or do not allow the requested observables
Analysis analyze(FrameReader& reader, Topology topology, const AnalysisSettings& settings,
                 const Callbacks& callbacks = {}, Workers& workers = Workers::serial());

/// The names of all observables, as used in options.
const std::vector<std::string>& observable_names();

/// Returns a name unchanged if an observable has this name.
/// @throws Error  if there is no observable of that name
std::string observable(const std::string& name);

}  // namespace polhode
