// SPDX-License-Identifier: MIT
#include "polhode/run/simulation/report/warnings.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>

#include "../errors.hpp"
#include "../folder.hpp"
#include "io/settings/quantity.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/run/simulation/simulation.hpp"
#include "run/simulation/report/warning_rules.hpp"
#include "run/simulation/system/stable_step.hpp"

using namespace polhode;

namespace {

/// A run of 64 waters for 10 ps without anything to object to.
RunSummary good() {
  RunSummary s;
  s.length = 10;
  s.samples = 1000;
  s.ratio = {0.005, 0.0002, Known::yes};
  s.potential_fluctuation = {20, 1, Known::yes};
  s.drift = {{0.001, 0.001}, 0.3, Known::yes};
  s.potential_drift = {{-0.1, 0.2}, 0.6, Known::yes};
  s.degrees_of_freedom = {189, {64, 64, 64}};
  s.temperatures.all = {300, 1, Known::yes};
  s.pressure = {0, 1, Known::yes};
  return s;
}

std::string kinds(const RunSummary& s, std::optional<TargetTemperature> target = {{300}}) {
  std::string all;
  for (const Warning& w : warnings_of_results(s, target)) {
    CHECK(!w.text.empty());
    CHECK(!w.remedy.empty());
    CHECK(std::abs(w.value) > 0);
    CHECK(w.bound > 0);
    all += w.kind + " ";
  }
  return all;
}

System system_of(const std::string& text) { return build_system(parse_config(text, "run.toml")); }

std::string salt(const std::string& electrostatics) {
  return R"([system]
molecules = [{ model = "spce", count = 20 }, { model = "na-spce", count = 1 },
             { model = "cl-spce", count = 1 }]
density = "0.5 g/cm3"
[forces]
cutoff = "0.5 nm"
electrostatics = ")" +
         electrostatics + "\"\n";
}

}  // namespace

TEST_CASE("a run without anything to object to has no warnings") { CHECK(kinds(good()).empty()); }

TEST_CASE("a mean temperature beyond three standard deviations is a warning") {
  RunSummary s = good();
  const double sd = std::hypot(300 / std::sqrt(2 * 381.0), 1);  // of runs from drawn momenta; error
  s.temperatures.all.value = 300 + 2.9 * sd;
  CHECK(kinds(s).empty());
  s.temperatures.all.value = 300 + 3.1 * sd;
  CHECK(kinds(s) == "temperature ");
  CHECK(kinds(s, std::nullopt).empty());
  s.temperatures.all.value = 300 - 3.1 * sd;
  CHECK(kinds(s) == "temperature ");
  // Of a large system, less than 1 % is nothing to object to.
  s.degrees_of_freedom = {3e6, {1e6, 1e6, 1e6}};
  s.temperatures.all = {302.9, 0.01, Known::yes};
  CHECK(kinds(s).empty());
  s.temperatures.all.value = 303.1;
  CHECK(kinds(s) == "temperature ");
}

// The scatter of drawn momenta, 11 K here, is no excuse for velocities that were not drawn.
TEST_CASE(
    "a temperature that the velocities of a file ignore is a warning beyond 2 % and 3 errors") {
  RunSummary s = good();
  s.temperatures.all = {300 - 5.9, 1, Known::yes};
  CHECK(kinds(s, {{300, true}}).empty());
  s.temperatures.all.value = 300 - 6.1;
  CHECK(kinds(s, {{300, true}}) == "temperature ");
  CHECK(kinds(s).empty());
  s.temperatures.all.error = 2.1;
  CHECK(kinds(s, {{300, true}}).empty());
  s.temperatures.all.value = 300 + 6.4;
  CHECK(kinds(s, {{300, true}}) == "temperature ");
}

TEST_CASE("without an error, the momentary scatter of the temperature counts") {
  RunSummary s = good();
  s.temperatures.all = {300 + 3.1 * 300 * std::hypot(1 / std::sqrt(762.0), 0), 0, Known::too_short};
  CHECK(kinds(s).empty());
  s.temperatures.all.value = 300 + 3.1 * 300 * std::sqrt(1 / 762.0 + 2 / 381.0);
  CHECK(kinds(s) == "temperature ");
}

// P(|t| > 6.62) = 0.27 % with four degrees of freedom, the number of an error from four modes.
TEST_CASE("an error from four modes counts by Student's t: 6.62 of them are not due to chance") {
  RunSummary s = good();
  const TargetTemperature kept{.value = 300, .kept = true};
  for (const double sign : {1.0, -1.0}) {
    s.temperatures.all = {300 + sign * 6.5, 1, Known::yes, 4};
    CHECK(kinds(s, kept).empty());
    s.temperatures.all.value = 300 + sign * 6.7;
    CHECK(kinds(s, kept) == "temperature ");
  }
  const double kbar = 1000 * unit("bar", Dimension::pressure);
  s = good();
  s.pressure = {5.65 * kbar, 0.1 * kbar, Known::yes, 4};
  CHECK(kinds(s).empty());
  s.pressure.value = 5.67 * kbar;
  CHECK(kinds(s) == "pressure ");
}

TEST_CASE("R above 5 % is a warning") {
  RunSummary s = good();
  s.ratio.value = 0.049;
  CHECK(kinds(s).empty());
  s.ratio.value = 0.051;
  CHECK(kinds(s) == "R ");
  s.ratio.value = std::nan("");
  CHECK(kinds(s).empty());
}

TEST_CASE("a drift is a warning if it is significant and makes up half of R") {
  RunSummary s = good();
  // A line that rises by √12 times R of the potential fluctuation makes the whole of R.
  const double whole = s.ratio.value * s.potential_fluctuation.value * std::sqrt(12.0) / s.length;
  s.drift = {{0.6 * whole, 0.01 * whole}, 1e-6, Known::yes};
  CHECK(kinds(s) == "drift ");
  s.drift.p_value = 0.002;
  CHECK(kinds(s).empty());
  s.drift = {{0.4 * whole, 0.01 * whole}, 1e-6, Known::yes};
  CHECK(kinds(s).empty());
  // 0.1 % of the fluctuation of the potential energy is nothing to object to, however small R is.
  s.ratio.value = 1e-5;
  s.drift.rate.value = 0.9e-3 * s.potential_fluctuation.value * std::sqrt(12.0) / s.length;
  CHECK(kinds(s).empty());
  s.drift.rate.value = -1.1e-3 * s.potential_fluctuation.value * std::sqrt(12.0) / s.length;
  CHECK(kinds(s) == "drift ");
}

// A walk of variance D t has the rms deviation √(D t/6) from its mean: R of 0.6 % of 20 kJ/mol in
// 10 ps. It is loud from 0.5 % on, if it makes up half of R², and a thermostat takes it up.
TEST_CASE("a random walk of the total energy is a warning if it matters") {
  RunSummary s = good();
  s.ratio = {0.007, 0, Known::grows};
  s.walk = std::pow(0.006 * 20, 2) * 6 / 10;
  CHECK(s.ratio_of_walk() == doctest::Approx(0.006));
  CHECK(kinds(s) == "walk ");
  s.ratio.value = 0.009;
  CHECK(kinds(s).empty());
  s.ratio.value = 0.006;
  s.walk = std::pow(0.0049 * 20, 2) * 6 / 10;
  CHECK(kinds(s).empty());
  s.walk = std::pow(0.006 * 20, 2) * 6 / 10;
  s.ensemble.settings.thermostat.emplace();
  CHECK(kinds(s, {{.value = 300, .kept = true}}).empty());
}

// R² of 6 % without a walk of 4 % is 4.5 %.
TEST_CASE("with a thermostat, R without the random walk is compared with 5 %") {
  RunSummary s = good();
  s.ratio = {0.06, 0, Known::grows};
  s.walk = std::pow(0.04 * 20, 2) * 6 / 10;
  CHECK(kinds(s) == "R ");
  const TargetTemperature kept{.value = 300, .kept = true};
  s.ensemble.settings.thermostat.emplace();
  CHECK(kinds(s, kept).empty());
  s.walk = 0;
  CHECK(kinds(s, kept) == "R ");
}

TEST_CASE("an energy drift matters by the bound of its warning, whatever its significance") {
  RunSummary s = good();
  const double whole = s.ratio.value * 20 * std::sqrt(12.0) / s.length;
  s.drift = {{-0.6 * whole, 0}, 1, Known::too_few_samples};
  CHECK(drift_matters(s));
  CHECK(s.relative_drift() == doctest::Approx(0.6 * 0.005 * std::sqrt(12.0)));
  s.drift.rate.value = 0.4 * whole;
  CHECK(!drift_matters(s));
}

TEST_CASE("a potential energy that still falls is a warning, one that rises is not") {
  RunSummary s = good();
  const double kinetic = 381 * 0.00831446 * 300 / 2;
  s.potential_drift = {{-0.021 * kinetic / s.length, 0.1}, 1e-5, Known::yes};
  CHECK(kinds(s) == "relaxation ");
  s.potential_drift.p_value = 0.01;
  CHECK(kinds(s).empty());
  s.potential_drift = {{-0.019 * kinetic / s.length, 0.1}, 1e-5, Known::yes};
  CHECK(kinds(s).empty());
  s.potential_drift = {{0.1 * kinetic / s.length, 0.1}, 1e-5, Known::yes};
  CHECK(kinds(s).empty());
}

TEST_CASE("a pressure beyond 5 kbar is a warning") {
  RunSummary s = good();
  const double kbar = 1000 * unit("bar", Dimension::pressure);
  for (const double sign : {1.0, -1.0}) {
    s.pressure = {sign * 5.2 * kbar, 0.1 * kbar, Known::yes};
    CHECK(kinds(s).empty());  // less than three errors above
    s.pressure = {sign * 5.4 * kbar, 0.1 * kbar, Known::yes};
    CHECK(kinds(s) == "pressure ");
  }
}

TEST_CASE("ions with a truncated Coulomb law or a reaction field are a warning") {
  for (const char* bad : {"coulomb", "reaction-field"}) {
    const auto warning = cutoff_of_ions(system_of(salt(bad)));
    REQUIRE(warning);
    CHECK(std::abs(warning->value) == doctest::Approx(1));
    CHECK(warning->text.find("0.5 nm") != std::string::npos);
    CHECK(warning->remedy.find("pme") != std::string::npos);
  }
  CHECK(!cutoff_of_ions(system_of(salt("pme"))));
  CHECK(
      !cutoff_of_ions(system_of("[system]\nmolecules = [{ model = \"spce\", count = 20 }]\n"
                                "density = \"0.5 g/cm3\"\n[forces]\ncutoff = \"0.4 nm\"\n")));
}

TEST_CASE("a step near the stability limit is a warning") {
  const std::string text = R"([system]
initial_configuration = "w512"
molecules = [{ model = "tip4p" }]
)";
  const Config config = parse_config(text, "run.toml");
  const System system = build_system(config);
  TrajectorySettings settings = trajectory_settings(config);
  settings.scheme = scheme_of("velocity-verlet");
  settings.step = 0.002;
  CHECK(!step_near_stability(system, settings));
  settings.step = 0.008;  // R is 31 %
  const auto warning = step_near_stability(system, settings);
  REQUIRE(warning);
  CHECK(warning->text.find("8 fs") != std::string::npos);
  CHECK(warning->bound == doctest::Approx(near_stability * 2).epsilon(1e-3));
}

TEST_CASE("a run that blew up advises the step of the stability warning") {
  const Config config = parse_config(R"([system]
initial_configuration = "w512"
molecules = [{ model = "tip4p" }]
[integrator]
scheme = "velocity-verlet"
step = "20 fs"
[run]
length = "20 ps"
)",
                                     "run.toml");
  System system = build_system(config);
  const TrajectorySettings settings = trajectory_settings(config);
  const auto warning = step_near_stability(system, settings);
  REQUIRE(warning);
  const std::string advised = warning->remedy.substr(std::string("use at most ").size());
  // Less than half of the step, so that the limit of the scheme decides.
  CHECK(max_stable_step(system, system.state, settings) < settings.step / 2);
  ForceField forces(system.topology, system.forces, system.state.box);
  const Trajectory trajectory = run_trajectory(system, forces, settings);
  CHECK(trajectory.failure.find("try " + advised + ", or equilibrate") != std::string::npos);
}

TEST_CASE(
    "the step advised after a run that blew up is the one of the warning, or half of its own") {
  const Config config = parse_config(
      "[system]\ndensity = \"0.2 g/cm3\"\n"
      "molecules = [{ model = \"argon\", count = 64 }]\n",
      "run.toml");
  const System lattice = build_system(config);
  TrajectorySettings settings = trajectory_settings(config);
  const double stable = max_stable_step(lattice, lattice.state, settings);
  // A step below the limit is halved; one beyond it, however far, becomes the limit.
  settings.step = 0.9 * stable;
  CHECK(shorter_step(lattice, lattice.state, settings).value() == doctest::Approx(0.45 * stable));
  for (const double factor : {1.1, 3.0, 30.0}) {
    settings.step = factor * stable;
    CHECK(shorter_step(lattice, lattice.state, settings).value() == stable);
  }
  CHECK(rounded_fs(0.2) == "200 fs");
  CHECK(rounded_fs(0.00628) == "6.3 fs");
  State overlapping = lattice.state;
  overlapping.q.set(1, overlapping.q[0] + Vec3<double>{0.05, 0, 0});
  CHECK_FALSE(shorter_step(lattice, overlapping, settings));
}

TEST_CASE("rounded charges make no ions, and positions in angstrom are a warning") {
  const auto system_with = [](const std::string& more) {
    return build_system(
        parse_config("[system]\ndensity = \"0.01 g/cm3\"\n"
                     "molecules = [{ model = { name = \"own\", source = \"user\", site = [\n"
                     "{ name = \"C\", element = \"C\", position = \"0 0 0 nm\", mass = \"12 u\", "
                     "charge = \"0.2 e\" },\n"
                     "{ name = \"F\", element = \"F\", mass = \"19 u\", " +
                         more +
                         " }] }, count = 8 }]\n"
                         "[forces]\nelectrostatics = \"coulomb\"\n",
                     "run.toml"));
  };
  for (const char* charge : {"-0.2", "-0.20002", "-0.195"})
    CHECK_FALSE(cutoff_of_ions(
        system_with("charge = \"" + std::string(charge) + " e\", position = \"0.152 0 0 nm\"")));
  CHECK(cutoff_of_ions(system_with("charge = \"0.6 e\", position = \"0.152 0 0 nm\"")));
  // The longest bond of a bead, and the shortest of atoms in the wrong unit.
  for (const char* x : {"0.07", "0.47", "0.59"})
    CHECK_FALSE(distant_sites(system_with("position = \"" + std::string(x) + " 0 0 nm\"")));
  for (const char* x : {"0.74", "1.52"}) {
    const auto warning = distant_sites(system_with("position = \"" + std::string(x) + " 0 0 nm\""));
    REQUIRE(warning);
    CHECK(warning->value == doctest::Approx(std::stod(x)));
    CHECK(warning->remedy.find("write A instead of nm") != std::string::npos);
  }
}

// The temperature of n degrees of freedom scatters by T √(2/n), and four times that is the bound.
TEST_CASE("velocities of a file far from the temperature asked for are a warning") {
  const Config config = parse_config(R"([system]
molecules = [{ model = "argon", count = 32 }]
density = "0.9 g/cm3"
temperature = "100 K"
[forces]
cutoff = "0.6 nm"
)",
                                     "run.toml");
  System system = build_system(config);
  system.new_velocities = false;
  const double bound = 4 * 100 * std::sqrt(2 / 93.0);
  for (const double sign : {1.0, -1.0}) {
    system.file_temperature = 100 + sign * 0.98 * bound;
    CHECK(!velocities_of_file(system, config));
    system.file_temperature = 100 + sign * 1.02 * bound;
    const auto warning = velocities_of_file(system, config);
    REQUIRE(warning);
    CHECK(warning->bound == doctest::Approx(bound));
  }
}

TEST_CASE("velocities of a file: kept, reported, compared with the temperature, or new ones") {
  const Folder folder;
  const std::string keys = R"(
molecules = [{ model = "argon", count = 32 }]
[forces]
cutoff = "0.6 nm"
[run]
length = "0.02 ps"
[output]
plot = "none"
trajectory_every = "0 ps"
prefix = ")";
  const auto config = [&](const std::string& first, const char* prefix = "out") {
    return parse_config("[system]\n" + first + keys + (folder / prefix) + "\"\n", "run.toml");
  };
  const std::string hot = "density = \"0.9 g/cm3\"\ntemperature = \"300 K\"";
  Simulation(config(hot)).run();
  const std::string file = "initial_configuration = \"" + (folder / "out-final.gro") + "\"\n";
  const auto notes = [&](const std::string& first) {
    std::string all;
    Callbacks callbacks;
    callbacks.message = [&](const std::string& line) { all += line + "\n"; };
    Simulation(config(file + first, "again")).run({.existing = ExistingFiles::replace}, callbacks);
    return all;
  };
  const auto has = [](const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
  };
  CHECK(!has(notes(""), "velocities"));  // nothing is ignored
  Simulation(config(hot)).run({.existing = ExistingFiles::replace});
  const std::string contradicted = notes("temperature = \"90 K\"\nseed = 3");
  CHECK(has(contradicted, "temperature and seed are not used"));
  CHECK(has(contradicted, "warning: the velocities of the initial configuration correspond to"));
  Simulation(config(hot)).run({.existing = ExistingFiles::replace});
  CHECK(!has(notes("temperature = \"310 K\""), "warning: the velocities"));  // within chance
  const std::string fresh = "velocities = \"new\"\ntemperature = \"90 K\"";
  Simulation(config(hot)).run({.existing = ExistingFiles::replace});
  CHECK(!has(notes(fresh), "velocities"));
  Simulation(config(hot)).run({.existing = ExistingFiles::replace});
  const Simulation drawn(config(file + fresh));
  const Energies now = drawn.energies();
  CHECK(temperature(now.kinetic(), degrees_of_freedom(drawn.system().topology).all()) ==
        doctest::Approx(90));
}

TEST_CASE("velocities that must come from a file without any are an error") {
  const Folder folder;
  std::ofstream(folder / "bare.gro") << "two argon atoms\n    2\n"
                                        "    1argon   AR    1   0.500   0.500   0.500\n"
                                        "    2argon   AR    2   1.500   1.500   1.500\n"
                                        "   2.50000   2.50000   2.50000\n";
  const auto built = [&](const std::string& velocities) {
    return system_of("[system]\nmolecules = [{ model = \"argon\" }]\ninitial_configuration = \"" +
                     (folder / "bare.gro") + "\"\n" + velocities);
  };
  CHECK(built("").new_velocities);
  CHECK(built("velocities = \"new\"").new_velocities);
  check_error([&] { built("velocities = \"from file\""); },
              {"bare.gro' has no velocities", "\"new\"", "system.velocities"});
}
