// SPDX-License-Identifier: MIT
// Performance on liquid water: force evaluations compared with the time of their bare arithmetic,
// and the time of each part of a step.
#pragma once

#include <string>
#include <vector>

#include "io/settings/output_units.hpp"
#include "polhode/model/state.hpp"
#include "polhode/run/callbacks.hpp"
#include "run/benchmark/peak_performance.hpp"

namespace polhode {

struct BenchmarkSettings {
  std::vector<std::size_t> sizes = {512, 4096};  ///< molecules
  std::vector<Precision> precisions = {Precision::mixed, Precision::double_precision};
  std::vector<int> threads = {1};
  bool quick = false;  ///< fewer and shorter repeats
};

/// Force evaluations with an up-to-date list.
struct EvaluationTiming {
  double switch_from = 0;                        ///< [nm]
  Timing forces, energies;                       ///< [s]: forces only, and with energies
  double arithmetic = 0, energy_arithmetic = 0;  ///< bare arithmetic of its pairs on one core [s]
  std::size_t pairs = 0;                         ///< within the cutoff
  double fill = 0;                               ///< fraction of the computed lanes that are within
                                                 ///< the cutoff
  Timing list;                                   ///< one build of the neighbour list [s]
};

/// Steps of a scheme, without energies.
struct StepTiming {
  std::string scheme;
  double step = 0;                                             ///< [ps]
  Timing all;                                                  ///< one step [s], the sum of its
                                                               ///< parts
  double forces = 0, list = 0, drift = 0, kick = 0, rest = 0;  ///< [s]
  double rebuilds = 0;                                         ///< of the list, per step
  double ns_per_day() const { return step / units::ps_per_ns / all.best * units::seconds_per_day; }
};

/// One system size in one precision with one number of threads.
struct SystemTiming {
  std::size_t molecules = 0;
  Precision precision = Precision::double_precision;
  int threads = 1;
  std::vector<EvaluationTiming> evaluations;  ///< switch from 0.765 nm and from 0.85 nm to 0.9 nm
  std::vector<StepTiming> steps;              ///< HOA2 4 fs, velocity Verlet 2 fs, GIER4 5 fs
};

struct Benchmark {
  std::vector<Limit> limits;          ///< one per precision
  std::vector<SystemTiming> systems;  ///< by size, precision, threads
  bool interrupted = false;           ///< the numbers are incomplete
  const Limit& limit(Precision precision) const;
  /// The largest relative spread of all timings in `systems`.
  double spread() const;
};

/// Measures TIP4P water at 297 K: n³ copies of the built-in configuration for 512 n³ molecules,
/// otherwise molecules on a lattice that were simulated for 0.1 ps.
/// @throws Error  if a size is too small for a cutoff of 0.9 nm
Benchmark run_benchmark(const BenchmarkSettings& settings, const Callbacks& callbacks = {});

/// Number of pairs of bodies closer than a distance, which is below half of the shortest box edge.
std::size_t pairs_within(const State& state, double distance);

}  // namespace polhode
