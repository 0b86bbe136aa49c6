// SPDX-License-Identifier: MIT
// Stated errors of the averages of a run against their scatter over many runs of one system.
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "polhode/io/settings/config.hpp"
#include "polhode/model/degrees_of_freedom.hpp"
#include "polhode/run/simulation/trajectory/trajectory.hpp"

using namespace polhode;

namespace {

constexpr std::size_t runs = 400;
constexpr std::size_t length = 16;  // of each [ps]

/// The statistics of consecutive parts of one trajectory: independent but for their ends, and at
/// one energy where it is constant.
struct Parts {
  std::vector<EnergyStatistics> statistics;
  DegreesOfFreedom degrees_of_freedom;
};

Parts consecutive_runs(const std::string& thermostat) {
  constexpr double sample = 0.04;  // [ps]
  const std::string text =
      "[system]\nmolecules = [{ model = \"n2\", count = 20 }]\n"
      "density = \"0.6 g/cm3\"\ntemperature = \"110 K\"\n"
      "[forces]\ncutoff = \"0.55 nm\"\n"
      "[integrator]\nscheme = \"hoa2\"\nstep = \"10 fs\"\n"
      "[run]\nlength = \"" +
      std::to_string(runs * length) + " ps\"\nsample = \"" + std::to_string(sample) + " ps\"\n";
  const Config config = parse_config(text + thermostat, "run.toml");
  System system = build_system(config);
  ForceField forces(system.topology, system.forces, system.state.box);
  equilibrate(system, forces, 3);
  Parts parts{std::vector<EnergyStatistics>(runs), degrees_of_freedom(system.topology)};
  const auto whole = static_cast<std::size_t>(std::lround(double(length) / sample));
  std::size_t samples = 0;
  Watch watch;
  watch.sample = [&](std::size_t, const State&, const Energies& now) {
    if (samples < runs * whole) parts.statistics[samples++ / whole].add(now);
  };
  REQUIRE(run_trajectory(system, forces, trajectory_settings(config), watch).failure.empty());
  return parts;
}

/// The rms of the stated errors divided by the scatter of the values.
double stated_over_scatter(const std::vector<EnergyStatistics>& parts,
                           const std::function<SeriesEstimate(const EnergyStatistics&)>& average) {
  double sum = 0, squares = 0, errors = 0, known = 0;
  for (const EnergyStatistics& part : parts) {
    const SeriesEstimate e = average(part);
    if (e.known != Known::yes) continue;
    ++known, sum += e.value, squares += e.value * e.value, errors += e.error * e.error;
  }
  CHECK(known > 0.9 * static_cast<double>(parts.size()));
  return std::sqrt(errors / known / ((squares - sum * sum / known) / (known - 1)));
}

}  // namespace

// The modes of a run give an error of 0.95 to 1.15 times the scatter of series of 20 correlation
// times and more (docs/statistics.md). The scatter of 400 runs is known to 3.5 %, of which three
// make 10.6 %: 0.85 to 1.27.
TEST_CASE("stated errors of the averages of a run equal their scatter over runs") {
  for (const std::string thermostat :
       {"", "[thermostat]\ntype = \"langevin\"\nfriction = \"5 1/ps\"\n",
        "[thermostat]\ntype = \"rescaling\"\ntime_constant = \"0.2 ps\"\n"}) {
    const auto [parts, n] = consecutive_runs(thermostat);
    const auto check = [&, &statistics = parts](const char* name, const auto& average) {
      const double ratio = stated_over_scatter(statistics, average);
      CAPTURE(thermostat);
      CAPTURE(std::string(name));
      CHECK(ratio > 0.85);
      CHECK(ratio < 1.27);
    };
    check("potential", [](const auto& p) { return p.potential_with_error(); });
    if (!thermostat.empty()) check("total", [](const auto& p) { return p.total_with_error(); });
    const auto temperatures = [&n = n](const EnergyStatistics& p) {
      return p.temperatures_with_errors(n);
    };
    check("temperature", [&](const auto& p) { return temperatures(p).all; });
    check("translation", [&](const auto& p) { return temperatures(p).translation; });
    for (std::size_t k = 0; k < 3; ++k)
      if (n.rotation[k] > 0)
        check("rotation", [&](const auto& p) { return temperatures(p).rotation[k]; });
    check("pressure", [](const auto& p) { return p.pressure(); });
    check("fluctuation of the potential energy",
          [](const auto& p) { return p.potential_fluctuation_with_error(); });
  }
}
