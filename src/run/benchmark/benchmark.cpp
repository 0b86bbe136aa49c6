// SPDX-License-Identifier: MIT
#include "run/benchmark/benchmark.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>

#include "base/stopwatch.hpp"
#include "forces/pairs/neighbours.hpp"
#include "forces/timed_forces.hpp"
#include "model/cell_list.hpp"
#include "polhode/base/error.hpp"
#include "polhode/forces/mesh/mesh_choice.hpp"
#include "polhode/integrate/integrator.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/run/simulation/trajectory/trajectory.hpp"

namespace polhode {
namespace {

constexpr std::size_t tile = 512;               // number of molecules of the built-in configuration
constexpr std::array switches = {0.765, 0.85};  // start of the switch [nm]
constexpr const char *reaction_field = "reaction field", *site_switch = "site switch",
                     *ewald_sum = "Ewald sum";
struct Motion {
  const char* scheme;
  double step;  // time step [ps]
  const char* interactions = reaction_field;
};
constexpr std::array motions = {
    Motion{"hoa2", 0.004}, Motion{"velocity-verlet", 0.002}, Motion{"gier4-fd", 0.005},
    Motion{"velocity-verlet", 0.002, site_switch}, Motion{"velocity-verlet", 0.002, ewald_sum}};

// Duration and number of repeats of each measurement. Large systems are measured less often.
struct Effort {
  double limit, evaluations, steps;  // durations of one repeat [s]
  std::size_t repeats, min_repeats;
  double max_seconds;  // maximum duration for a size, after the smallest number of repeats [s]
};
constexpr Effort normal{0.5, 0.02, 0.05, 9, 2, 12}, quick{0.2, 0.01, 0.02, 5, 2, 3};

std::size_t tiles_along_edge(std::size_t molecules) {
  const auto n = static_cast<std::size_t>(
      std::llround(std::cbrt(static_cast<double>(molecules) / static_cast<double>(tile))));
  return n * n * n * tile == molecules ? n : 0;
}

System side_by_side(System water, std::size_t n) {
  const State one = water.state;
  const Box box{static_cast<double>(n) * one.box.edge};
  water.topology.parts[0].count = n * n * n * one.size();
  check_count(water.topology);
  water.bodies = Bodies(water.topology);
  water.state = State(n * n * n * one.size(), box);
  std::size_t to = 0;
  for (std::size_t x = 0; x < n; ++x)
    for (std::size_t y = 0; y < n; ++y)
      for (std::size_t z = 0; z < n; ++z)
        for (std::size_t i = 0; i < one.size(); ++i, ++to) {
          const Vec3<double> tiles{static_cast<double>(x), static_cast<double>(y),
                                   static_cast<double>(z)};
          water.state.q.set(to, one.q[i] + scaled(tiles, one.box.edge));
          water.state.orientation.set(to, one.orientation[i]);
        }
  draw_momenta(water, 1);
  return water;
}

System liquid_water(std::size_t molecules, const Callbacks& callbacks, Workers& workers) {
  Config config = default_config();
  config.forces = benchmark_forces(Precision::mixed, switches[0]);
  const std::size_t n = tiles_along_edge(molecules);
  if (n == 1) return build_system(config);
  if (n > 1) return side_by_side(build_system(config), n);
  const System one = build_system(config);
  config.system.initial_configuration.clear();
  config.system.molecules[0].count = molecules;
  config.system.density = one.topology.mass() / one.state.box.volume();
  config.source = fmt::format("a box of {} waters", molecules);
  config.given.clear();  // errors refer to the box, not to a file
  System water = build_system(config);
  ForceField forces(water.topology, water.forces, water.state.box, workers);
  equilibrate(water, forces, 0.1, {.stop = callbacks.stop}, workers);
  return water;
}

// Repeated timings of one kind of force evaluation.
struct EvaluationRepeats {
  std::vector<double> forces, energies, list;
  double lanes = 0;
};

void repeat(EvaluationRepeats& repeats, const System& water, const ForceSettings& settings,
            Workers& workers, double seconds) {
  // Memory is allocated at different addresses for each repeat, because the memory speed depends on
  // the address.
  const std::vector<std::byte> elsewhere(1 + 1088 * repeats.list.size());
  ForceField forces(water.topology, settings, water.state.box, workers);
  Load load;
  forces(water.state, load);
  repeats.list.push_back(forces.neighbours().seconds());
  repeats.lanes = static_cast<double>(forces.neighbours().lanes());
  constexpr std::size_t min_repeats = 3;
  const Stopwatch clock;
  for (std::size_t n = 0; n < min_repeats || clock.seconds() < seconds; ++n) {
    repeats.forces.push_back(seconds_of([&] { forces.forces_alone(water.state, load); }));
    repeats.energies.push_back(seconds_of([&] { forces(water.state, load); }));
  }
}

struct StepRepeats {
  std::vector<double> forces, other, drift, kick;
  double list = 0, steps = 0, rebuilds = 0;
};

void repeat(StepRepeats& repeats, const Motion& motion, System& water,
            const ForceSettings& settings, Workers& workers, double seconds) {
  constexpr std::size_t min_repeats = 10;
  const Config config = default_config(
      {.settings = {
           {"forces.precision", {std::string(name_of(settings.precision))}, "benchmark"}}});
  const Scheme scheme = scheme_of(motion.scheme);
  ForceField forces(water.topology, settings, water.state.box, workers);
  TimedForces timed{forces};
  Integrator integrator(scheme, water.bodies, timed, config.integrator.lambda, workers);
  integrator.advance(water.state, motion.step, 1, false);

  const NeighbourList& list = forces.neighbours();
  const double list_before = list.seconds();
  const auto rebuilds_before = static_cast<double>(list.rebuilds());
  std::size_t steps = 0;
  for (const Stopwatch clock; steps < min_repeats || clock.seconds() < seconds; ++steps) {
    timed.seconds = 0;
    const double in_list = list.seconds();
    const double all = seconds_of([&] { integrator.advance(water.state, motion.step, 1, false); });
    repeats.forces.push_back(timed.seconds - (list.seconds() - in_list));
    repeats.other.push_back(all - timed.seconds);
  }
  repeats.list += list.seconds() - list_before;
  repeats.rebuilds += static_cast<double>(list.rebuilds()) - rebuilds_before;
  repeats.steps += static_cast<double>(steps);

  // Times drifts and kicks separately, on a state that is discarded.
  State state = water.state;
  for (std::size_t n = 0; n < min_repeats; ++n) {
    repeats.drift.push_back(
        seconds_of([&] { drift(state, water.bodies, motion.step / 2, workers); }));
    repeats.kick.push_back(seconds_of(
        [&] { kick(state, water.bodies, integrator.last_load(), motion.step / 2, workers); }));
  }
}

StepTiming summary_of(const StepRepeats& repeats, const Motion& motion) {
  StepTiming s;
  s.scheme = motion.scheme;
  s.interactions = motion.interactions;
  s.step = motion.step;
  const Timing forces = timing(repeats.forces), other = timing(repeats.other);
  const Scheme scheme = scheme_of(motion.scheme);
  const auto stages = [&](Flow flow) {
    double n = 0;
    for (const Stage& stage : scheme.stages())
      n += stage.flow == flow ? (stage.xi != 0 ? 3 : 1) : 0;  // a gradient kick is weighted as
                                                              // three kicks
    return n;
  };
  s.forces = forces.best;
  s.list = repeats.list / repeats.steps;
  s.rebuilds = repeats.rebuilds / repeats.steps;
  s.drift = std::min(other.best, stages(Flow::drift) * timing(repeats.drift).best);
  s.kick = std::min(other.best - s.drift, stages(Flow::kick) * timing(repeats.kick).best);
  s.rest = other.best - s.drift - s.kick;
  s.all = {forces.best + s.list + other.best, forces.median + s.list + other.median};
  return s;
}

// Measures all kinds of evaluations and steps for one system size, in interleaved order.
class Measurement {
 public:
  Measurement(std::size_t molecules, const BenchmarkSettings& settings, const Effort& effort,
              const std::vector<Limit>& limits, const Callbacks& callbacks,
              std::vector<std::unique_ptr<Workers>>& workers)
      : effort_(effort),
        callbacks_(callbacks),
        water_(liquid_water(molecules, callbacks, *workers.back())),
        mesh_(
            mesh_for(with_interactions(benchmark_forces(Precision::mixed, switches[0]), ewald_sum),
                     water_.state.box, water_.topology)) {
    for (std::size_t p = 0; p < settings.precisions.size(); ++p)
      for (const auto& w : workers) kinds_.push_back({limits[p], *w, water_, {}, {}});
  }

  /// Runs the measurement. The result is incomplete if a callback stops the benchmark.
  void run(const std::function<void(double)>& report) {
    const Stopwatch clock;
    for (std::size_t n = 0; n < effort_.repeats; ++n) {
      if (n >= effort_.min_repeats && clock.seconds() > effort_.max_seconds) break;
      repeat_evaluations();
      repeat_steps();
      if (callbacks_.stopped()) return;
      report(std::max(static_cast<double>(n + 1) / static_cast<double>(effort_.repeats),
                      std::min(1.0, clock.seconds() / effort_.max_seconds)));
    }
  }

  std::vector<SystemTiming> result() const {
    const std::size_t pairs = pairs_within(water_.state, forces(kinds_[0], 0).cutoff);
    std::vector<SystemTiming> result;
    for (const Kind& kind : kinds_) {
      SystemTiming s{water_.state.size(), kind.limit.precision, kind.workers.threads(), {}, {}};
      for (std::size_t k = 0; k < switches.size(); ++k) {
        const std::size_t whole = pairs_within(water_.state, switches[k]);
        const EvaluationRepeats& r = kind.evaluations[k];
        s.evaluations.push_back({switches[k], timing(r.forces), timing(r.energies),
                                 kind.limit.seconds(whole, pairs - whole, false),
                                 kind.limit.seconds(whole, pairs - whole, true), pairs,
                                 static_cast<double>(pairs) / r.lanes, timing(r.list)});
      }
      for (std::size_t k = 0; k < motions.size(); ++k)
        s.steps.push_back(summary_of(kind.steps[k], motions[k]));
      result.push_back(s);
    }
    return result;
  }

 private:
  struct Kind {
    const Limit& limit;
    Workers& workers;
    System moving;  // system that advances from one repeat to the next
    std::array<EvaluationRepeats, switches.size()> evaluations;
    std::array<StepRepeats, motions.size()> steps;
  };
  void repeat_evaluations() {
    for (Kind& kind : kinds_)
      for (std::size_t k = 0; k < switches.size() && !callbacks_.stopped(); ++k)
        repeat(kind.evaluations[k], water_, forces(kind, k), kind.workers, effort_.evaluations);
  }
  void repeat_steps() {
    for (std::size_t k = 0; k < motions.size(); ++k)
      for (Kind& kind : kinds_)
        if (!callbacks_.stopped())
          repeat(kind.steps[k], motions[k], kind.moving, forces(kind, motions[k]), kind.workers,
                 effort_.steps);
  }
  static ForceSettings forces(const Kind& kind, std::size_t k) {
    return benchmark_forces(kind.limit.precision, switches[k]);
  }
  ForceSettings forces(const Kind& kind, const Motion& motion) const {
    ForceSettings settings = with_interactions(forces(kind, 0), motion.interactions);
    if (settings.electrostatics == Electrostatics::pme) settings.mesh = mesh_;
    return settings;
  }

  Effort effort_;
  const Callbacks& callbacks_;
  System water_;
  MeshSettings mesh_;  // mesh of the Ewald sum
  std::vector<Kind> kinds_;
};

}  // namespace

const Limit& Benchmark::limit(Precision precision) const {
  return *std::find_if(limits.begin(), limits.end(),
                       [&](const Limit& l) { return l.precision == precision; });
}

double Benchmark::spread() const {
  double max_spread = 0;
  for (const SystemTiming& s : systems) {
    for (const EvaluationTiming& e : s.evaluations)
      max_spread = std::max({max_spread, e.forces.spread(), e.energies.spread()});
    for (const StepTiming& t : s.steps) max_spread = std::max(max_spread, t.all.spread());
  }
  return max_spread;
}

ForceSettings with_interactions(ForceSettings settings, std::string_view interactions) {
  if (interactions != reaction_field) settings.truncation = Truncation::site_switch;
  if (interactions == ewald_sum) settings.electrostatics = Electrostatics::pme;
  return settings;
}

std::size_t pairs_within(const State& state, double distance) {
  struct Centre {
    Vec3<double> r;
  };
  std::vector<Centre> centres;
  for (std::size_t i = 0; i < state.size(); ++i) centres.push_back({state.q[i]});
  std::size_t pairs = 0;
  CellList(centres, state.box, distance).each_pair([&](const Centre& a, const Centre& b) {
    pairs += norm2(state.box.minimum_image(a.r - b.r)) < distance * distance;
  });
  return pairs;
}

Benchmark run_benchmark(const BenchmarkSettings& settings, const Callbacks& callbacks) {
  const Effort& effort = settings.quick ? quick : normal;
  std::vector<std::unique_ptr<Workers>> workers;
  for (const int threads : settings.threads) workers.push_back(std::make_unique<Workers>(threads));
  Benchmark result;
  for (const Precision precision : settings.precisions)
    result.limits.push_back(measure_limit(precision, effort.limit));
  const auto sizes = static_cast<double>(settings.sizes.size());
  for (std::size_t k = 0; k < settings.sizes.size(); ++k) {
    const std::size_t molecules = settings.sizes[k];
    const auto tell = [&](double done) {
      callbacks.report(
          {"bench", (static_cast<double>(k) + done) / sizes, fmt::format("{} waters", molecules)});
    };
    tell(0);
    Measurement measurement(molecules, settings, effort, result.limits, callbacks, workers);
    measurement.run(tell);
    result.interrupted = callbacks.stopped();
    if (result.interrupted) return result;
    for (SystemTiming& s : measurement.result()) result.systems.push_back(std::move(s));
  }
  return result;
}

}  // namespace polhode
