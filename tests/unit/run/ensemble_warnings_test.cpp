// SPDX-License-Identifier: MIT
#include "run/simulation/report/warning_rules.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <tuple>

using namespace polhode;

namespace {

std::string kinds(const RunSummary& s, const std::optional<TargetTemperature>& target = {}) {
  std::string all;
  for (const Warning& w : warnings_of_results(s, target)) {
    CHECK(!w.text.empty());
    CHECK(!w.remedy.empty());
    all += w.kind + " ";
  }
  return all;
}

/// A run at constant pressure, 10 ps, without anything to object to.
RunSummary npt(const BoxMoves& type = CellRescaling{0.5}) {
  RunSummary s;
  s.length = 10;
  s.samples = 1000;
  s.ratio = {0.005, 0.0002, Known::yes};
  s.potential_fluctuation = {20, 1, Known::yes};
  s.ensemble.settings = {300, ThermostatSettings{}, BarostatSettings{.type = type}, {}};
  s.ensemble.barostat.emplace();
  s.ensemble.barostat->volume = {15, 0.01, Known::yes};
  s.ensemble.barostat->volume_drift = {{0.001, 0.001}, 0.3, Known::yes};
  s.ensemble.barostat->moves = 2000;
  s.ensemble.barostat->accepted = 1800;
  return s;
}

RunSummary hybrid_summary() {
  RunSummary s;
  s.samples = 1000;
  s.ensemble.settings = {300, {}, {}, HybridMonteCarloSettings{}};
  s.ensemble.hybrid_monte_carlo = {100, 80, {1.002, 0.01, Known::yes}, 0, {},
                                   {},  {}, {0.001, 0.005, Known::yes}};
  return s;
}

}  // namespace

TEST_CASE("a volume that drifts by more than 0.5 % is a warning") {
  CHECK(kinds(npt()).empty());
  for (const double sign : {1.0, -1.0}) {
    RunSummary s = npt();
    Drift& drift = s.ensemble.barostat->volume_drift;
    drift = {{sign * 0.0051 * 15 / 10, 0.0001}, 1e-6, Known::yes};
    CHECK(kinds(s) == "volume ");
    drift.p_value = 0.002;
    CHECK(kinds(s).empty());
    drift = {{sign * 0.0049 * 15 / 10, 0.0001}, 1e-6, Known::yes};
    CHECK(kinds(s).empty());
  }
}

// The slower a volume relaxes, the less is its error known.
TEST_CASE("a volume that changes by more than 0.5 % with an unknown error is a warning") {
  for (const Known unknown : {Known::too_short, Known::too_few_samples}) {
    RunSummary s = npt();
    s.ensemble.barostat->volume_drift = {{-0.0051 * 15 / 10, 0}, 1, unknown};
    CHECK(kinds(s) == "volume ");
    s.ensemble.barostat->volume_drift = {{-0.0049 * 15 / 10, 0}, 1, unknown};
    CHECK(kinds(s).empty());
  }
}

// Its volume relaxes with the time constant times its compressibility over that of the barostat.
TEST_CASE("a system softer than its barostat assumes needs a longer run") {
  RunSummary s = npt();
  s.ensemble.settings.barostat->compressibility = 2;
  auto& found = s.ensemble.barostat->compressibility;
  found = {2.05, 0.1, Known::yes};  // 20 times 0.5 ps times 1.025 are more than 10 ps
  CHECK(kinds(s) == "volume_samples ");
  found = {1.9, 0.1, Known::yes};
  CHECK(kinds(s).empty());
  found = {20, 0, Known::too_short};
  CHECK(kinds(s).empty());
}

// Of 2000 moves, 1000 or 200 of which are expected, chance accounts for 3 √(2000 p (1 − p)) = 67.1
// or 40.2.
TEST_CASE("too few accepted moves of the box are a warning") {
  for (const auto& [kind, last, first] : {std::tuple{BoxMoves(CellRescaling{0.5}), 932u, 933u},
                                          {BoxMoves(VolumeMoves{}), 159u, 160u}}) {
    RunSummary s = npt(kind);
    s.ensemble.barostat->accepted = last;
    CHECK(kinds(s) == "barostat ");
    s.ensemble.barostat->accepted = first;
    CHECK(kinds(s).empty());
    s.ensemble.barostat->moves = s.ensemble.barostat->accepted = 0;
    CHECK(kinds(s).empty());
  }
}

TEST_CASE("runs too short for fluctuations of the volume have a warning") {
  RunSummary s = npt();
  s.length = 9.9;  // 20 time constants of 0.5 ps are 10 ps
  CHECK(kinds(s) == "volume_samples ");
  s = npt(VolumeMoves{});
  s.ensemble.barostat->moves = s.ensemble.barostat->accepted = 99;
  CHECK(kinds(s) == "volume_samples ");
  s.ensemble.barostat->moves = s.ensemble.barostat->accepted = 100;
  CHECK(kinds(s).empty());
}

TEST_CASE("hybrid Monte Carlo: acceptance outside 0.5 to 0.99, beyond chance, is a warning") {
  RunSummary s = hybrid_summary();
  auto& h = *s.ensemble.hybrid_monte_carlo;
  CHECK(kinds(s).empty());
  h.accepted = 34;
  CHECK(kinds(s) == "acceptance ");
  h.accepted = 36;
  CHECK(kinds(s).empty());
  h.trajectories = h.accepted = 890;  // chance of 0.99: 3 √(0.99 · 0.01/n) = 0.01 for n = 891
  CHECK(kinds(s).empty());
  h.trajectories = h.accepted = 892;
  CHECK(kinds(s) == "acceptance ");
}

TEST_CASE("hybrid Monte Carlo: a mean of exp(-dH/kT) off 1 by three errors is a warning") {
  RunSummary s = hybrid_summary();
  auto& weight = s.ensemble.hybrid_monte_carlo->weight;
  for (const double sign : {1.0, -1.0}) {
    weight = {1 + sign * 0.029, 0.01, Known::yes};
    CHECK(kinds(s).empty());
    weight.value = 1 + sign * 0.031;
    CHECK(kinds(s) == "weights ");
    weight.known = Known::too_short;
    CHECK(kinds(s).empty());
  }
}

// Rare large weights make the mean of exp(−ΔH/kT) uncertain.
TEST_CASE("hybrid Monte Carlo: the bounded mean finds what the error of the weights hides") {
  RunSummary s = hybrid_summary();
  auto& h = *s.ensemble.hybrid_monte_carlo;
  h.weight = {4, 2, Known::yes};
  CHECK(kinds(s).empty());
  for (const double sign : {1.0, -1.0}) {
    h.bounded_weight = {sign * 0.016, 0.005, Known::yes};
    CHECK(kinds(s) == "weights ");
    h.weight.known = Known::too_short;
    CHECK(kinds(s) == "weights ");
    h.bounded_weight.value = sign * 0.014;
    CHECK(kinds(s).empty());
    h.weight.known = Known::yes;
  }
}

TEST_CASE("moves of the box beyond the bound of its shape are a warning") {
  RunSummary s = npt();
  s.ensemble.barostat->beyond_shape = 1;
  CHECK(kinds(s) == "shape ");
}

TEST_CASE("hybrid Monte Carlo has no warning about R and drift, a barostat none of the pressure") {
  RunSummary s = hybrid_summary();
  s.length = 10;
  s.potential_fluctuation = {20, 1, Known::yes};
  s.ratio = {0.2, 0.001, Known::yes};
  s.drift = {{1, 0.001}, 1e-9, Known::yes};
  CHECK(kinds(s).empty());
  s.ensemble = {};
  CHECK(kinds(s) == "R drift ");
  RunSummary dense = npt();
  dense.pressure = {1000, 1, Known::yes};  // 16.6 kbar
  CHECK(kinds(dense).empty());
  dense.ensemble = {};
  CHECK(kinds(dense) == "pressure ");
}

// The mean of a canonical run scatters by its statistical error alone; 11 K more at constant
// energy.
TEST_CASE("with a thermostat, the bound on the mean temperature is 3 errors, at least 1 %") {
  RunSummary s = npt();
  s.degrees_of_freedom = {189, {64, 64, 64}};
  for (const double sign : {1.0, -1.0}) {
    s.temperatures.all = {300 + sign * 5.9, 2, Known::yes};
    CHECK(kinds(s, {{.value = 300, .kept = true}}).empty());
    s.temperatures.all.value = 300 + sign * 6.1;
    CHECK(kinds(s, {{.value = 300, .kept = true}}) == "temperature ");
    CHECK(kinds(s, {{.value = 300}}).empty());
    s.temperatures.all = {300 + sign * 2.9, 0.1, Known::yes};
    CHECK(kinds(s, {{.value = 300, .kept = true}}).empty());
  }
}
