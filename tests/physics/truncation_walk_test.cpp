// SPDX-License-Identifier: MIT
// The random walk of the energy by passages through the switching range, against its prediction.
#include "run/simulation/report/truncation_walk.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "polhode/base/units.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/io/settings/config.hpp"
#include "polhode/run/simulation/trajectory/trajectory.hpp"

using namespace polhode;

namespace {

/// A walk's variance per time [(kJ/mol)²/ps]: measured over 0.2 ps, and predicted.
struct Walk {
  double measured = 0, predicted = 0;
};

Walk walk(const std::string& truncation, int femtoseconds) {
  const std::string text =
      "[system]\nmolecules = [{ model = \"tip4p\", count = 64 }]\ndensity = \"0.997 g/cm3\"\n"
      "temperature = \"300 K\"\n[forces]\ncutoff = \"0.6 nm\"\nswitch = \"0.45 nm\"\n"
      "electrostatics = \"reaction-field\"\ntruncation = \"" +
      truncation + "\"\n[integrator]\nscheme = \"gier4\"\nstep = \"" +
      std::to_string(femtoseconds) + " fs\"\n[run]\nlength = \"16 ps\"\nsample = \"200 fs\"\n";
  const Config config = parse_config(text, "run.toml");
  System system = build_system(config);
  ForceField forces(system.topology, system.forces, system.state.box);
  equilibrate(system, forces, 4);
  std::vector<double> energies;
  Watch watch;
  watch.sample = [&](std::size_t, const State&, const Energies& now) {
    energies.push_back(now.total());
  };
  const TrajectorySettings settings = trajectory_settings(config);
  const Trajectory trajectory = run_trajectory(system, forces, settings, watch);
  REQUIRE(trajectory.failure.empty());
  double squares = 0;
  for (std::size_t k = 1; k < energies.size(); ++k)
    squares += std::pow(energies[k] - energies[k - 1], 2);
  const EnergyStatistics& statistics = trajectory.statistics.energies;
  const double T =
      statistics.temperatures_with_errors(degrees_of_freedom(system.topology)).all.value;
  return {squares / static_cast<double>(energies.size() - 1) / settings.sample,
          truncation_walk(system.topology, system.forces, statistics.first.volume, T,
                          settings.scheme, settings.step)};
}

}  // namespace

// 80 changes of the energy know a variance to 16 %, so three standard errors are 48 %. The
// prediction assumes a uniform distribution, and leaves out derivatives beyond the first that
// jumps. Their terms are of relative size vh/width, here a tenth.
TEST_CASE("a site switch makes the energy walk as predicted from its smoothness") {
  const Walk at_4 = walk("site-switch", 4), at_2 = walk("site-switch", 2);
  INFO("4 fs: " << at_4.measured << " predicted " << at_4.predicted << ", 2 fs: " << at_2.measured
                << " predicted " << at_2.predicted);
  for (const Walk& w : {at_4, at_2}) {
    CHECK(w.measured > w.predicted / 1.6);
    CHECK(w.measured < w.predicted * 1.6);
  }
  // h⁶ for smoothness 2: a factor of 64, known to 2 × 16 % at one standard deviation.
  CHECK(at_4.measured / at_2.measured > 64 / 2.5);
  CHECK(at_4.measured / at_2.measured < 64 * 2.5);
  // Centres are slower than sites, and dipoles interact less than charges: a hundredth at most.
  const Walk whole = walk("molecule-switch", 4);
  CHECK(whole.predicted < at_4.predicted / 100);
  CHECK(whole.measured < at_4.measured / 30);  // mostly the bounded energy error
}

// Far apart, two molecules interact as dipoles, and ⟨u²⟩ = 2/3 (K μ²/r³)² over random orientations.
// The mean over 400 orientations is known to 10 %, and higher moments of the charges add terms of
// relative size (0.08/0.9)², about 1 %. Short-range potentials at 0.9 nm are below 1 % of u. So D
// is known to 30 %, three standard errors. TIP4P has a site without charge, and one with a charge
// alone.
TEST_CASE("the walk of a molecule switch is that of dipoles") {
  const std::string text =
      "[system]\nmolecules = [{ model = \"tip4p\", count = 512 }]\ndensity = \"0.997 g/cm3\"\n"
      "temperature = \"300 K\"\n[forces]\ncutoff = \"1 nm\"\nswitch = \"0.9 nm\"\n"
      "truncation = \"molecule-switch\"\n";
  const System system = build_system(parse_config(text, "run.toml"));
  const Molecule& water = system.topology.parts.front().molecule;
  Vec3<double> dipole{0, 0, 0};
  for (const Site& site : water.sites) dipole += site.charge * site.r;
  const double kT = units::boltzmann * 300, volume = system.state.box.volume(), N = 512;
  const double width = 0.1, jump = 60 / std::pow(width, 3);  // third derivative of the C² switch
  // ⟨|v|⁷⟩ of a normal distribution of variance 2 kT/m.
  const double moment =
      std::pow(4 * kT / water.mass, 3.5) * std::tgamma(4.0) / std::sqrt(units::pi);
  for (const char* name : {"velocity-verlet", "gier4"}) {
    const Scheme scheme = scheme_of(name);
    const double step = 0.004;
    double expected = 0;
    for (const double r : {0.9, 1.0}) {
      const double u2 = 2.0 / 3 * std::pow(units::coulomb * dot(dipole, dipole) / (r * r * r), 2);
      expected += N * N / (2 * volume) * 4 * units::pi * r * r * jump * jump * u2 * moment *
                  std::pow(step, 6) * passage_error(scheme, 2);
    }
    const double D = truncation_walk(system.topology, system.forces, volume, 300, scheme, step);
    CHECK(std::abs(D / expected - 1) < 0.3);
  }
}
