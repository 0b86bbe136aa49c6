// SPDX-License-Identifier: MIT
// What a trajectory tells: its frames are read once, in batches, and go to the observables wanted.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "polhode/base/workers.hpp"
#include "polhode/io/frame_file.hpp"
#include "polhode/measure/conditions.hpp"
#include "polhode/measure/dielectric.hpp"
#include "polhode/measure/displacement.hpp"
#include "polhode/measure/radial_distribution.hpp"
#include "polhode/measure/reorientation.hpp"
#include "polhode/measure/velocity_correlation.hpp"

namespace polhode {

enum class Observable { rdf, msd, rotation, velocity, dielectric, density };

struct AnalysisSettings {
  /// Empty: all that the frames allow. Of a choice, what they do not allow is an error.
  std::set<Observable> what;
  double from = 0;                 ///< frames before are left out [ps]
  std::optional<double> interval;  ///< between frames, in place of their times [ps]
  double window = 10;              ///< longest lag of correlations [ps]
  std::vector<SitePair> pairs;     ///< empty: `site_pairs`
  std::optional<double> reach;     ///< of g(r); without it 1 nm, or half of the shortest edge
  double bin = 0.002;              ///< of g(r) [nm]
};

/// The observables of the frames that were read; those that were not wanted are missing.
struct Analysis {
  Topology topology;
  std::size_t frames = 0;
  double first = 0, last = 0;  ///< times [ps]
  double interval = 0;         ///< between frames; 0 if nothing needed it [ps]
  Box box;                     ///< of the first frame
  bool has_velocities = false;
  double deviation = 0;            ///< of atoms from the sites of rigid models, at most [nm]
  bool stopped = false;            ///< before the file ended
  std::vector<std::string> notes;  ///< what was left out, and what to beware of

  std::optional<Conditions> conditions;  ///< of every analysis
  bool density = false;                  ///< whether they are wanted for themselves
  std::vector<SitePair> pairs;
  std::optional<RadialDistribution> radial;
  std::optional<Displacement> displacement;
  std::optional<Reorientation> reorientation;
  std::optional<VelocityCorrelation> velocity;
  std::optional<TotalDipole> dipole;
};

struct AnalysisWatch {
  std::function<void(std::size_t frames, double time)> each_batch = [](std::size_t, double) {};
  std::function<bool()> stop = [] { return false; };
};

/// Reads all frames. Memory holds a batch of them, one for each thread, beside the windows of the
/// correlations; bodies are fitted to frames side by side, observables share the threads.
/// @throws Error  if frames do not fit the topology, or do not allow what was asked for
Analysis analysis(FrameReader& reader, Topology topology, const AnalysisSettings& settings,
                  const AnalysisWatch& watch = {}, Workers& workers = Workers::serial());

/// The names of observables as options have them.
const std::vector<std::string>& observable_names();

/// The observable of a name.
/// @throws Error  if there is none
Observable observable(const std::string& name);

}  // namespace polhode
