// SPDX-License-Identifier: MIT
// The tables [thermostat], [barostat] and [hybrid_monte_carlo] of run files.
#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <initializer_list>
#include <limits>
#include <string>
#include <tuple>

#include "../errors.hpp"
#include "../folder.hpp"
#include "io/settings/ensemble_names.hpp"
#include "io/settings/ensemble_text.hpp"
#include "io/settings/quantity.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/io/settings/config.hpp"
#include "polhode/run/simulation/simulation.hpp"
#include "run/simulation/system/system_notes.hpp"
#include "run/simulation/trajectory/ensemble_moves.hpp"

using namespace polhode;

namespace {

Config config_of(const std::string& tables, const std::string& temperature = "90 K",
                 const std::string& scheme = "hoa2", const std::string& step = "2 fs") {
  return parse_config(
      "[system]\nmolecules = [{ model = \"argon\", count = 32 }]\n"
      "density = \"0.9 g/cm3\"\ntemperature = \"" +
          temperature + "\"\n[forces]\ncutoff = \"0.6 nm\"\n[integrator]\nscheme = \"" + scheme +
          "\"\nstep = \"" + step + "\"\n" + tables,
      "run.toml");
}

TrajectorySettings settings_of(const std::string& tables, const std::string& temperature = "90 K",
                               const std::string& scheme = "hoa2",
                               const std::string& step = "2 fs") {
  return trajectory_settings(config_of(tables, temperature, scheme, step));
}

const std::string thermostat = "[thermostat]\n";
const std::string barostat = "[barostat]\npressure = \"1 bar\"\n";
const std::string hybrid = "[hybrid_monte_carlo]\n";

}  // namespace

TEST_CASE("settings of an ensemble that contradict each other or the scheme are refused") {
  const auto refused = [](const std::string& tables, std::initializer_list<const char*> words,
                          const std::string& temperature = "90 K",
                          const std::string& scheme = "hoa2", const std::string& step = "2 fs") {
    CAPTURE(tables);
    const auto read = [&] { settings_of(tables, temperature, scheme, step); };
    check_error(read, words);
    check_error(read, {"run.toml"});
  };
  refused("[barostat]\n", {"no pressure for the barostat", "pressure = \"1 bar\""});
  refused(barostat, {"a barostat", "needs a thermostat", "[thermostat]"});
  refused(hybrid + thermostat, {"hybrid Monte Carlo controls the temperature without", "leave"});
  refused(hybrid + barostat + "time_constant = \"120 fs\"\n[run]\nlength = \"1 ps\"\n",
          {"time_constant of 120 fs", "interval of its moves, 150 fs", "whole trajectories"},
          "90 K", "hoa2", "15 fs");
  refused(hybrid, {"without stages O"}, "90 K", "baoab");
  refused("", {"needs a thermostat", "[thermostat]"}, "90 K", "baoab");
  refused(thermostat + "type = \"rescaling\"\ntime_constant = \"1 fs\"\n",
          {"time_constant of 1 fs", "step of 2 fs", "100 to 1000 fs"});
  refused(thermostat + barostat + "time_constant = \"50 fs\"\n",
          {"time_constant of 50 fs", "interval of its moves, 100 fs"});
  refused(thermostat + "time_constant = \"1 ps\"\n", {"rescaling", "leave it out"});
  refused(thermostat + "type = \"rescaling\"\nfriction = \"1 1/ps\"\n",
          {"langevin", "leave it out"});
  refused(thermostat + barostat + "edges = [\"xy\", \"yz\"]\n", {"two groups"});
  refused("", {"above 0 K", "with a [thermostat], which then cools"}, "0 K");
  refused(hybrid, {"above 0 K", "hybrid Monte Carlo", "[thermostat] at 0 K"}, "0 K");
  refused(thermostat + barostat, {"above 0 K", "a barostat"}, "0 K");
  refused(thermostat + "[run]\nshadow_sample = \"100 fs\"\n",
          {"has no shadow energy", "leave shadow_sample out"});
}

// Settings that a program sets itself, without a run file that would refuse them.
TEST_CASE("settings of an ensemble are checked in the library as well") {
  const auto refused = [](const EnsembleSettings& ensemble,
                          std::initializer_list<const char*> words) {
    TrajectorySettings settings{.scheme = scheme_of("hoa2-ends"), .step = 0.002, .length = 1};
    settings.ensemble = ensemble;
    check_error([&] { check_ensemble(settings); }, words);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const BarostatSettings good{.compressibility = default_compressibility()};
  BarostatSettings none = good, thin = good, at_once = good, unknown = good;
  none.compressibility = 0;
  thin.compressibility = 20 * unit("1/bar", Dimension::compressibility);
  at_once.every = 0, unknown.type = CellRescaling{nan};
  refused({300, ThermostatSettings{}, none, {}},
          {"barostat.compressibility = 0 1/bar must be 1e-7 1/bar or more"});
  refused({300, ThermostatSettings{}, thin, {}}, {"10 1/bar"});
  refused({300, ThermostatSettings{}, at_once, {}},
          {"barostat.every = 0 ps must be longer than 0 ps"});
  refused({300, ThermostatSettings{}, unknown, {}}, {"time_constant", "1 to 10 ps"});
  refused({300, Langevin{.friction = -1}, {}, {}},
          {"thermostat.friction = -1 1/ps", "0 1/ps or more"});
  refused({300, Langevin{.rotational_friction = nan}, {}, {}}, {"friction", "0 1/ps or more"});
  refused({300, Rescaling{0}, {}, {}}, {"thermostat.time_constant = 0 ps", "0.1 to 1 ps"});
  TrajectorySettings settings{.scheme = scheme_of("hoa2-ends"), .step = 0.002, .length = 1};
  settings.ensemble = {300, ThermostatSettings{}, good, {}};
  check_ensemble(settings);
}

TEST_CASE("a negative pressure, friction zero and a scheme with its own bath are legal") {
  const double bar = unit("bar", Dimension::pressure);
  CHECK(settings_of(thermostat + "[barostat]\npressure = \"-500 bar\"\n")
            .ensemble.barostat->pressure == doctest::Approx(-500 * bar));
  CHECK(settings_of(thermostat + "friction = \"0 1/ps\"\n").ensemble.thermostat ==
        ThermostatSettings(Langevin{0, 0}));
  CHECK(settings_of(thermostat).scheme.name() == "hoa2-ends");
  CHECK(settings_of(thermostat, "90 K", "baoab").scheme.name() == "baoab");
  CHECK(settings_of(hybrid, "90 K", "gier4").scheme.name() == "gier4");
  CHECK(settings_of(hybrid, "90 K", "gier4-fd").scheme.name() == "gier4-fd");
  CHECK(settings_of(barostat + hybrid).ensemble.barostat.has_value());
}

TEST_CASE("lengths and samples of hybrid Monte Carlo are rounded up to whole trajectories") {
  const TrajectorySettings s =
      settings_of(hybrid + "steps = 7\n[run]\nlength = \"30 fs\"\nsample = \"4 fs\"\n");
  CHECK(s.steps() == 21);
  CHECK(s.steps_per_sample() == 7);
}

TEST_CASE("moves of the box are made between whole trajectories of hybrid Monte Carlo") {
  const auto moves = [](const std::string& every, int steps) {
    return settings_of(barostat + "every = \"" + every + "\"\n" + hybrid +
                       "steps = " + std::to_string(steps) + "\n");
  };
  // Steps of 2 fs: the nearest number of trajectories, and at least one.
  for (const auto& [every, steps, expected] : {std::tuple{"100 fs", 10, 50u},
                                               {"100 fs", 7, 49u},
                                               {"100 fs", 40, 40u},
                                               {"100 fs", 30, 60u},
                                               {"100 fs", 1000, 1000u},
                                               {"1 fs", 3, 3u},
                                               {"20 fs", 1, 10u}}) {
    CAPTURE(std::string(every));
    CAPTURE(steps);
    const TrajectorySettings s = moves(every, steps);
    CHECK(s.steps_per_move() == expected);
    CHECK(s.steps_per_move() % s.steps_per_trajectory() == 0);
    CHECK(s.move_interval() == doctest::Approx(0.002 * expected).epsilon(1e-14));
  }
  const TrajectorySettings langevin =
      settings_of(thermostat + barostat + "every = \"7.2 fs\"\n");  // whole steps
  CHECK(langevin.steps_per_move() == 4);
}

TEST_CASE("an interval between moves of the box that differs from what was asked for is noted") {
  const auto notes = [](const std::string& tables) {
    std::string all;
    Callbacks callbacks;
    callbacks.message = [&](const std::string& text) { all += text + "\n"; };
    note_ensemble(settings_of(tables), callbacks);
    return all;
  };
  const std::string longer = notes(barostat + hybrid + "steps = 80\n");
  CHECK(longer.find("100 fs between moves of the box is rounded to 160 fs") != std::string::npos);
  CHECK(longer.find("80 steps of 2 fs") != std::string::npos);
  CHECK(notes(barostat + hybrid).find("rounded") == std::string::npos);
  CHECK(notes(barostat + thermostat).find("note") == std::string::npos);
  CHECK(notes(thermostat + barostat + "edges = [\"xy\", \"z\"]\n").find("For a fluid use edges") !=
        std::string::npos);
}

// Friction alone: exp(−2γt) of the kinetic energy, up to what the forces add to it; gas of argon.
TEST_CASE("a thermostat at 0 K cools") {
  const Folder folder;
  std::ofstream(folder / "hot.gro")
      << "two argon atoms\n    2\n"
         "    1argon   AR    1   0.500   0.500   0.500  0.3000  0.1000  0.2000\n"
         "    2argon   AR    2   2.000   2.000   2.000 -0.3000 -0.1000 -0.2000\n"
         "   4.00000   4.00000   4.00000\n";
  Simulation simulation(
      parse_config("[system]\nmolecules = [{ model = \"argon\" }]\ntemperature = \"0 K\"\n"
                   "initial_configuration = \"" +
                       (folder / "hot.gro") +
                       "\"\n[forces]\ncutoff = \"1 nm\"\n[thermostat]\nfriction = \"2 1/ps\"\n",
                   "run.toml"));
  const double before = simulation.energies().kinetic();
  simulation.step(500);  // 1 ps
  CHECK(simulation.energies().kinetic() == doctest::Approx(std::exp(-4.0) * before).epsilon(1e-9));
}

TEST_CASE("every setting of an ensemble belongs to the identity of a run") {
  const auto text = [](const std::string& tables) {
    std::string all;
    for (const auto& [key, value] : ensemble_texts(config_of(tables).ensemble))
      all += key + "=" + value + "\n";
    return all;
  };
  const std::string langevin = thermostat, rescaling = thermostat + "type = \"rescaling\"\n";
  CHECK(text("").empty());
  CHECK(text(langevin) != text(rescaling));
  CHECK(text(langevin) != text(langevin + "friction = \"2 1/ps\"\n"));
  CHECK(text(langevin) != text(langevin + "rotational_friction = \"2 1/ps\"\n"));
  CHECK(text(rescaling) != text(rescaling + "time_constant = \"0.6 ps\"\n"));
  for (const char* key :
       {"type = \"monte-carlo\"", "time_constant = \"3 ps\"", "every = \"0.2 ps\"",
        "compressibility = \"5e-5 1/bar\"", "metropolis = false", "edges = [\"z\"]"}) {
    CAPTURE(std::string(key));
    CHECK(text(barostat) != text(barostat + key + "\n"));
  }
  CHECK(text(barostat) != text("[barostat]\npressure = \"2 bar\"\n"));
  CHECK(text(hybrid) != text(hybrid + "steps = 11\n"));
  CHECK(text(hybrid) != text(hybrid + "refresh = \"90 %\"\n"));
}

// Each trajectory adds its error to the conserved energy, accepted or not: no sign of a blow-up.
TEST_CASE("hybrid Monte Carlo does not end where the conserved energy exceeds the kinetic energy") {
  const Config config = config_of(hybrid + "steps = 5\n", "90 K", "velocity-verlet");
  System system = build_system(config);
  TrajectorySettings settings = trajectory_settings(config);
  settings.step = 0.06;
  settings.length = 120;
  settings.sample = 0.3;
  ForceField forces(system.topology, system.forces, system.state.box);
  Energies first{}, last{};
  Watch watch;
  watch.sample = [&](std::size_t steps, const State&, const Energies& now) {
    (steps == 0 ? first : last) = now;
  };
  const Trajectory t = run_trajectory(system, forces, settings, watch);
  CHECK(t.failure.empty());
  CHECK(t.steps == 2000);
  CHECK(t.ensemble.hybrid.trajectories == 400);
  CHECK(last.conserved() - first.conserved() > first.kinetic());
}
