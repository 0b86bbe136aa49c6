// SPDX-License-Identifier: MIT
// A run suspended at any step and resumed from its checkpoint equals the uninterrupted run.
#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <random>
#include <vector>

#include "polhode/integrate/scheme_text.hpp"
#include "polhode/integrate/with_bath.hpp"
#include "polhode/io/settings/nested_scheme_text.hpp"
#include "run/simulation/files/checkpoint.hpp"
#include "scenes.hpp"

using namespace polhode;

namespace {

using Bits = std::vector<std::uint64_t>;

void add(Bits& bits, double x) { bits.push_back(std::bit_cast<std::uint64_t>(x)); }
void add(Bits& bits, const Component& column) {
  for (const double x : column.values()) add(bits, x);
}
void add(Bits& bits, const Vec3Column& v) { add(bits, v.x), add(bits, v.y), add(bits, v.z); }

void add(Bits& bits, const TimeBlocks& blocks) {
  add(bits, blocks.samples_per_block);
  for (const auto& [weight, sum] : blocks.blocks) {
    add(bits, weight);
    for (const double x : sum) add(bits, x);
  }
}

// All results of a run except its computing times.
Bits bits(const State& state, const Trajectory& t) {
  const TrajectoryStatistics& s = t.statistics;
  Bits all{t.steps,
           t.force_evaluations,
           t.derivatives,
           t.near_evaluations,
           t.near_derivatives,
           t.measurements,
           t.list_rebuilds,
           s.energies.samples,
           s.shadow.samples,
           s.stretches.samples,
           s.stretches.stretches};
  add(all, state.q), add(all, state.p), add(all, state.ell), add(all, state.time);
  add(all, state.orientation.w), add(all, state.orientation.x);
  add(all, state.orientation.y), add(all, state.orientation.z);
  const Energies& e = s.energies.first;
  for (const double x : {e.time, e.van_der_waals, e.coulomb, e.translation, e.rotation[0],
                         e.rotation[1], e.rotation[2], e.pressure, s.shadow.first, s.shadow.start,
                         s.stretches.sums[0], s.stretches.sums[1], s.stretches.sums[2],
                         s.stretches.sums[3], s.stretches.mean, s.stretches.squares})
    add(all, x);
  const auto& [heat, barostat, hybrid] = t.ensemble;
  for (const double x : {state.box.edge.x, state.box.edge.y, state.box.edge.z, heat, barostat.work,
                         barostat.edges.x, barostat.edges.y, barostat.edges.z, hybrid.work})
    add(all, x);
  for (const std::uint64_t n : {barostat.moves, barostat.accepted, barostat.beyond_shape,
                                hybrid.trajectories, hybrid.accepted})
    all.push_back(n);
  for (const TimeBlocks* blocks :
       {&s.energies.blocks, &s.shadow.blocks, &s.configurational.blocks, &hybrid.weights})
    add(all, *blocks);
  return all;
}

System mixture(Electrostatics electrostatics, Precision precision) {
  const scenes::Scene scene = scenes::lattice({{"tip4p", 90}, {"argon", 35}}, 0.4, 2.0, 3);
  ForceSettings forces{.cutoff = 0.8, .switch_from = 0.65, .skin = 0.01};
  forces.truncation = Truncation::site_switch;
  forces.electrostatics = electrostatics;
  forces.precision = precision;
  return {scene.topology, scene.bodies, scene.state, forces, 300};
}

// Through a file, as for a resumed run.
RunState stored(const RunState& at) {
  const auto folder = std::filesystem::temp_directory_path() /
                      ("polhode-restart-" + std::to_string(reinterpret_cast<std::uintptr_t>(&at)));
  std::filesystem::create_directories(folder);
  const CheckpointFiles files{(folder / "a").string(), (folder / "b").string()};
  Checkpoint checkpoint;
  checkpoint.at = at;
  write_checkpoint(files, checkpoint, {});
  checkpoint = read_checkpoint(files.newest, {});
  std::filesystem::remove_all(folder);
  return checkpoint.at;
}

// Energies every 3 steps of 25: those of the last step are not part of a longer run.
TrajectorySettings settings_of(const char* name, Precision precision) {
  const double step = 0.002;
  const NestedScheme scheme = nested_scheme_of(name);
  return {.scheme = scheme.outer,
          .step = step,
          .length = 25 * step,
          .sample = 3 * step,
          .lambda = precision == Precision::mixed ? 1 : 1e-4,
          .inner = scheme.inner,
          .configurational_sample = 6 * step,
          .seed = 4,
          .stretch = 9 * step};
}

struct EnsembleCase {
  const char* scheme;
  EnsembleSettings ensemble;
};

// Each thermostat and hybrid Monte Carlo, without a barostat and with each.
std::vector<EnsembleCase> ensemble_cases() {
  std::vector<EnsembleCase> cases;
  const BarostatSettings rescaling{.compressibility = 7e-4, .every = 0.006},
      coupled{.compressibility = 7e-4,
              .every = 0.006,
              .edges = {{true, true, false}, {false, false, true}}},
      moves{.type = VolumeMoves{}, .compressibility = 1e-5, .every = 0.01};
  for (const std::optional<BarostatSettings>& barostat :
       {std::optional<BarostatSettings>{}, std::optional{rescaling}, std::optional{coupled},
        std::optional{moves}}) {
    const auto add = [&](const char* scheme, std::optional<ThermostatSettings> thermostat,
                         std::optional<HybridMonteCarloSettings> hybrid) {
      cases.push_back({scheme, {300, thermostat, barostat, hybrid}});
    };
    add("hoa2-ends", Langevin{5, 20}, {});
    add("baoab", Langevin{5, 20}, {});
    add("gier4-middle", Rescaling{}, {});
    add("hoa2-ends", SeparateRescaling{}, {});
    add("hoa2", {}, HybridMonteCarloSettings{.steps = 4});
    add("position-verlet", {}, HybridMonteCarloSettings{.steps = 4, .refresh = 0.3});
  }
  return cases;
}

// 24 steps; samples and moves of the box are not at the same steps.
TrajectorySettings settings_of(const EnsembleCase& of) {
  const double step = 0.002;
  return {.scheme = scheme_of(of.scheme),
          .step = step,
          .length = 24 * step,
          .sample = 4 * step,
          .seed = 4,
          .ensemble = of.ensemble};
}

}  // namespace

TEST_CASE("a run can be resumed from any step bit for bit, for any number of threads") {
  std::mt19937_64 random(11);
  for (const Electrostatics electrostatics : {Electrostatics::reaction_field, Electrostatics::pme})
    for (const Precision precision : {Precision::double_precision, Precision::mixed})
      for (const char* name :
           {"velocity-verlet", "hoa2", "gier4", "position-verlet",
            "hoa2 / velocity-verlet x 2 within 0.5 nm",
            "position-verlet / gier4-fd x 1 within 0.5 nm", "gier4 / gier4 x 1 within 0.5 nm"}) {
        CAPTURE(int(electrostatics));
        CAPTURE(int(precision));
        CAPTURE(name);
        const TrajectorySettings settings = settings_of(name, precision);
        std::vector<RunState> kept;
        System whole = mixture(electrostatics, precision);
        ForceField forces(whole.topology, whole.forces, whole.state.box);
        Watch watch;
        watch.due = [] { return true; };
        watch.checkpoint = [&](RunState at) { kept.push_back(std::move(at)); };
        const Trajectory t = run_trajectory(whole, forces, settings, watch);
        CHECK(t.list_rebuilds > 3);  // otherwise the list would not be tested
        CHECK(t.statistics.configurational.blocks.blocks.size() == 5);
        CHECK(t.statistics.stretches.stretches == 3);
        const Bits expected = bits(whole.state, t);

        // Checkpoints change nothing, nor does a length that is reached in two parts.
        System plain = mixture(electrostatics, precision);
        ForceField its_forces(plain.topology, plain.forces, plain.state.box);
        const Trajectory without = run_trajectory(plain, its_forces, settings);
        CHECK((bits(plain.state, without) == expected));

        // Nor do configurational temperatures, which an inner scheme does not change either.
        TrajectorySettings silent = settings;
        silent.configurational_sample = 0;
        System unasked = mixture(electrostatics, precision);
        ForceField of_unasked(unasked.topology, unasked.forces, unasked.state.box);
        Trajectory other = run_trajectory(unasked, of_unasked, silent);
        other.statistics.configurational = t.statistics.configurational;
        CHECK((bits(unasked.state, other) == expected));

        REQUIRE(kept.size() == 26);
        for (const int threads : {1, 2, 3}) {
          const RunState from = stored(kept[random() % kept.size()]);
          CAPTURE(threads);
          CAPTURE(from.steps);
          Workers workers(threads);
          System system = mixture(electrostatics, precision);
          ForceField again(system.topology, system.forces, system.state.box, workers);
          const Trajectory rest = run_trajectory(system, again, settings, {}, workers, &from);
          CHECK((bits(system.state, rest) == expected));
        }
      }
}

TEST_CASE("a run that ended between two samples is extended as if it had been run at once") {
  const double step = 0.002;
  TrajectorySettings settings{scheme_of("hoa2"), step, 20 * step, 3 * step};
  System whole = mixture(Electrostatics::reaction_field, Precision::double_precision);
  ForceField forces(whole.topology, whole.forces, whole.state.box);
  const Trajectory at_once = run_trajectory(whole, forces, settings);
  const Bits expected = bits(whole.state, at_once);

  settings.length = 10 * step;
  RunState last;
  Watch watch;
  watch.checkpoint = [&](RunState at) { last = std::move(at); };
  System first = mixture(Electrostatics::reaction_field, Precision::double_precision);
  ForceField its(first.topology, first.forces, first.state.box);
  const Trajectory half = run_trajectory(first, its, settings, watch);
  CHECK(half.statistics.energies.samples == 5);  // at steps 0, 3, 6, 9 and 10
  CHECK(last.statistics.energies.samples == 4);
  CHECK(last.steps == 10);

  settings.length = 20 * step;
  System second = mixture(Electrostatics::reaction_field, Precision::double_precision);
  ForceField again(second.topology, second.forces, second.state.box);
  const Trajectory rest = run_trajectory(second, again, settings, {}, Workers::serial(), &last);
  CHECK((bits(second.state, rest) == expected));
}

TEST_CASE("samples of the shadow energy of a resumed run equal those of an uninterrupted one") {
  // Energies every 2 steps, brackets at every third of them: at steps 0, 6, 12, 18 and 24.
  const double step = 0.002;
  const TrajectorySettings settings{scheme_of("hoa2"), step, 25 * step, 2 * step, 1e-4, 6 * step};
  std::vector<RunState> kept;
  System whole = mixture(Electrostatics::reaction_field, Precision::double_precision);
  ForceField forces(whole.topology, whole.forces, whole.state.box);
  Watch watch;
  watch.due = [] { return true; };
  watch.checkpoint = [&](RunState at) { kept.push_back(std::move(at)); };
  const Trajectory t = run_trajectory(whole, forces, settings, watch);
  REQUIRE(t.statistics.shadow.samples == 5);
  const Bits expected = bits(whole.state, t);
  for (const std::size_t steps : {1u, 6u, 7u, 12u, 17u, 25u}) {
    const RunState from = stored(kept.at(steps));
    CAPTURE(steps);
    CHECK(from.statistics.shadow.samples == steps / 6 + 1);
    System system = mixture(Electrostatics::reaction_field, Precision::double_precision);
    ForceField again(system.topology, system.forces, system.state.box);
    const Trajectory rest = run_trajectory(system, again, settings, {}, Workers::serial(), &from);
    CHECK((bits(system.state, rest) == expected));
  }
}

TEST_CASE("samples through a postprocessor of a resumed run equal those of an uninterrupted one") {
  const double step = 0.002;
  for (const char* name : {"velocity-verlet", "takahashi-imada-fd", "gier4"}) {
    CAPTURE(name);
    TrajectorySettings settings{scheme_of(name), step, 25 * step, 2 * step};
    settings.processed = true;
    std::vector<RunState> kept;
    System whole = mixture(Electrostatics::pme, Precision::double_precision);
    ForceField forces(whole.topology, whole.forces, whole.state.box);
    Watch watch;
    watch.due = [] { return true; };
    watch.checkpoint = [&](RunState at) { kept.push_back(std::move(at)); };
    const Bits expected = bits(whole.state, run_trajectory(whole, forces, settings, watch));
    for (const std::size_t steps : {1u, 6u, 7u, 25u}) {
      const RunState from = stored(kept.at(steps));
      CAPTURE(steps);
      System system = mixture(Electrostatics::pme, Precision::double_precision);
      ForceField again(system.topology, system.forces, system.state.box);
      const Trajectory rest = run_trajectory(system, again, settings, {}, Workers::serial(), &from);
      CHECK((bits(system.state, rest) == expected));
    }
  }
}

TEST_CASE("a suspended equilibration is resumed bit for bit") {
  const auto prepared = [](System& system, const RunState* from, const Watch& watch) {
    ForceField forces(system.topology, system.forces, system.state.box);
    const bool done = equilibrate(system, forces, 0.11, watch, Workers::serial(), from);
    const ListMemory list = forces.list_memory(system.state.box);
    Bits all{done, list.rebuilds};
    add(all, system.state.q), add(all, system.state.p), add(all, system.state.ell);
    add(all, list.built_at);
    return all;
  };
  System whole = mixture(Electrostatics::reaction_field, Precision::double_precision);
  const Bits expected = prepared(whole, nullptr, {});
  for (const int stop_after : {5, 47, 100}) {
    CAPTURE(stop_after);
    RunState left;
    int steps = 0;
    Watch watch;
    watch.stop = [&] { return ++steps == stop_after; };
    watch.checkpoint = [&](RunState at) { left = std::move(at); };
    System first = mixture(Electrostatics::reaction_field, Precision::double_precision);
    prepared(first, nullptr, watch);
    REQUIRE(left.equilibrated.has_value());
    CHECK(*left.equilibrated <= 0.001 * stop_after);
    const RunState from = stored(left);
    System second = mixture(Electrostatics::reaction_field, Precision::double_precision);
    CHECK((prepared(second, &from, {}) == expected));
  }
}

TEST_CASE("thermostats, barostats and hybrid Monte Carlo resume bit for bit, for 1 and 3 threads") {
  std::mt19937_64 random(7);
  for (const EnsembleCase& of : ensemble_cases()) {
    CAPTURE(std::string(of.scheme));
    CAPTURE(of.ensemble.barostat.has_value());
    const TrajectorySettings settings = settings_of(of);
    const bool mesh = of.ensemble.barostat && of.ensemble.barostat->edges.size() == 2;
    const auto system_of = [mesh] {
      return mesh ? mixture(Electrostatics::pme, Precision::mixed)
                  : mixture(Electrostatics::reaction_field, Precision::double_precision);
    };
    std::vector<RunState> kept;
    System whole = system_of();
    ForceField forces(whole.topology, whole.forces, whole.state.box);
    Watch watch;
    watch.due = [] { return true; };
    watch.checkpoint = [&](RunState at) { kept.push_back(std::move(at)); };
    const Trajectory t = run_trajectory(whole, forces, settings, watch);
    REQUIRE(t.failure.empty());
    CHECK(t.ensemble.exchanged() != 0);
    CHECK((t.ensemble.barostat.accepted > 0) == of.ensemble.barostat.has_value());
    const Bits expected = bits(whole.state, t);

    // Hybrid Monte Carlo has checkpoints between trajectories only.
    REQUIRE(kept.size() == (of.ensemble.hybrid_monte_carlo ? 7 : 25));
    for (std::size_t k = 0; k < kept.size(); k += 1 + random() % 6) {
      const RunState from = stored(kept[k]);
      const int threads = k % 2 == 0 ? 3 : 1;
      CAPTURE(from.steps);
      CAPTURE(threads);
      Workers workers(threads);
      System system = system_of();
      ForceField again(system.topology, system.forces, system.state.box, workers);
      const Trajectory rest = run_trajectory(system, again, settings, {}, workers, &from);
      CHECK((bits(system.state, rest) == expected));
    }
  }
}

// The bath at the ends leaves the stages between as they are.
TEST_CASE("a thermostat without friction is constant energy, bit for bit") {
  for (const char* name : {"velocity-verlet", "hoa2", "gier4"}) {
    CAPTURE(std::string(name));
    TrajectorySettings settings = settings_of({name, {}});
    const auto run = [&] {
      System system = mixture(Electrostatics::reaction_field, Precision::double_precision);
      ForceField forces(system.topology, system.forces, system.state.box);
      const Trajectory t = run_trajectory(system, forces, settings);
      return bits(system.state, t);
    };
    const Bits constant_energy = run();
    settings.scheme = with_bath(settings.scheme, BathPlace::ends);
    settings.ensemble = {300, Langevin{0, 0}, {}, {}};
    CHECK((run() == constant_energy));
    settings.ensemble.thermostat = Langevin{0, 1e-9};
    CHECK((run() != constant_energy));
  }
}
