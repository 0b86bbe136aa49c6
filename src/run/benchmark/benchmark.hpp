// SPDX-License-Identifier: MIT
// Performance for liquid water: the time of a force evaluation compared with the time of its pair
// arithmetic, and the time of each part of a step.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/settings/output_units.hpp"
#include "polhode/model/state.hpp"
#include "polhode/run/callbacks.hpp"
#include "polhode/run/quantities.hpp"
#include "run/benchmark/peak_performance.hpp"

namespace polhode {

struct BenchmarkSettings {
  std::vector<std::size_t> sizes = {512, 4096};  ///< numbers of molecules
  std::vector<Precision> precisions = {Precision::mixed, Precision::double_precision};
  std::vector<int> threads = {1};
  bool quick = false;  ///< whether measurements are shorter and repeated less often
};

/// Timings of force evaluations with an up-to-date list.
struct EvaluationTiming {
  double switch_from = 0;   ///< switching distance [nm], at which the switch starts
  Timing forces, energies;  ///< time of an evaluation [s], without and with energies
  double arithmetic = 0, energy_arithmetic = 0;  ///< time of the pair arithmetic on one core [s]
  std::size_t pairs = 0;                         ///< number of pairs within the cutoff
  double fill = 0;                               ///< fraction of the computed lanes with a pair
                                                 ///< within the cutoff
  Timing list;                                   ///< time of one build of the neighbour list [s]
};

/// Timings of the steps of a scheme, without energies.
struct StepTiming {
  std::string scheme, interactions;
  double step = 0;  ///< time step [ps]
  Timing all;       ///< time of one step [s], the sum of the times of its parts
  double forces = 0, list = 0, drift = 0, kick = 0, rest = 0;  ///< times of the parts of a step [s]
  double rebuilds = 0;  ///< number of rebuilds of the list per step
  double ns_per_day() const { return step / units::ps_per_ns / all.best * units::seconds_per_day; }
};

/// Timings for a given system size, precision and number of threads.
struct SystemTiming {
  std::size_t molecules = 0;
  Precision precision = Precision::double_precision;
  int threads = 1;
  std::vector<EvaluationTiming> evaluations;  ///< evaluations with switching distances of 0.765 nm
                                              ///< and 0.85 nm, and a cutoff of 0.9 nm
  std::vector<StepTiming> steps;              ///< steps of HOA2 at 4 fs, velocity Verlet at 2 fs,
                                              ///< and GIER4 at 5 fs; then velocity Verlet with
                                              ///< other interactions
};

struct Benchmark {
  std::vector<Limit> limits;          ///< limit for each precision
  std::vector<SystemTiming> systems;  ///< timings by size, precision and number of threads
  bool interrupted = false;           ///< whether the benchmark was interrupted, so that the
                                      ///< numbers are incomplete
  const Limit& limit(Precision precision) const;
  /// The largest relative spread of all timings in `systems`.
  double spread() const;
};

/// Benchmarks TIP4P water at 297 K. A system of 512 n³ molecules consists of n³ copies of the
/// built-in configuration. Systems of other sizes start from a lattice, followed by a simulation of
/// 0.1 ps.
/// @throws Error  if a size is too small for a cutoff of 0.9 nm
Benchmark run_benchmark(const BenchmarkSettings& settings, const Callbacks& callbacks = {});

/// The force settings for the interactions that a StepTiming names: "reaction field" with the
/// truncation of `settings`, "site switch", or "Ewald sum".
ForceSettings with_interactions(ForceSettings settings, std::string_view interactions);

/// The number of pairs of bodies that are closer than a distance. The distance must be below half
/// of the shortest box edge.
std::size_t pairs_within(const State& state, double distance);

/// The computer on which the benchmark ran.
struct Computer {
  std::string processor, instruction_set;
  std::vector<int> threads;
};

/// The results of a benchmark as a list, from which text, JSON and the manual are made.
Quantities quantities(const Benchmark& benchmark, const Computer& computer);

}  // namespace polhode
