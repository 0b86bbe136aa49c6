// SPDX-License-Identifier: MIT
// Exact laws of barostats: the volume of an ideal gas.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "polhode/base/units.hpp"
#include "polhode/ensemble/barostat.hpp"
#include "polhode/ensemble/langevin.hpp"
#include "polhode/measure/correlated_series.hpp"
#include "scenes.hpp"

using namespace polhode;

namespace {

using scenes::kelvin;
using scenes::kT;
constexpr double pressure = 0.5;

struct Volume {
  SeriesEstimate mean, variance;
  BarostatMemory memory;
};

// Free bodies, with new momenta before each move of the box.
Volume volume_of(const scenes::Scene& scene, BarostatSettings settings, int moves) {
  settings.pressure = pressure;
  settings.compressibility = 1 / pressure;  // that of an ideal gas
  const LangevinSettings maxwell{.kT = kT, .seed = 4};
  Barostat barostat(settings, kelvin, scene.bodies, 3);
  State state = scene.state;
  const double N = double(state.size());
  state.box.edge = std::cbrt(N * kT / pressure) * Vec3<double>{1, 1, 1};
  Load load(state.size());
  TimeBlocks blocks;
  for (int k = 0; k < moves; ++k) {
    refresh_momenta(state, scene.bodies, maxwell, 0, std::uint64_t(k));
    barostat.move(state, load, scenes::no_forces, std::uint64_t(k));
    const double V = state.box.volume() * pressure / kT;
    blocks.add(std::array{V, V * V});
  }
  return {series_estimate(blocks.means(), [](auto mean) { return mean[0]; }),
          series_estimate(blocks.means(), [](auto mean) { return mean[1] - mean[0] * mean[0]; }),
          barostat.memory()};
}

// V P/kT has a Gamma distribution of this shape: its mean and its variance. A deviation of 4
// standard errors, themselves known to 20 %, occurs by chance in 1 of 1,000 checks; a shape that
// differs by 1 is 10 errors away or more.
void check_shape(const Volume& v, double shape) {
  CAPTURE(v.mean.value);
  CAPTURE(v.mean.error);
  CAPTURE(v.variance.value);
  CAPTURE(v.variance.error);
  REQUIRE(v.mean.known == Known::yes);
  CHECK(std::abs(v.mean.value - shape) < 4 * v.mean.error);
  CHECK(std::abs(v.variance.value - shape) < 4 * v.variance.error);
  CHECK(v.mean.error < 0.1);
}

constexpr CoupledEdges xyz{true, true, true}, xy{true, true, false}, z{false, false, true};

}  // namespace

// exp(−(K + P₀V)/kT) over V, positions and momenta with the centre of mass at rest, where moves
// scale positions and inversely momenta: the space of N − 1 positions, V^{N−1}.
TEST_CASE("cell rescaling: an ideal gas has V from Gamma(N, kT/P), whatever its sites and edges") {
  for (const char* molecule : {"argon", "tip5p", "benzene"}) {
    CAPTURE(std::string(molecule));
    const scenes::Scene scene = scenes::lattice({{molecule, 6}}, 0.4, 3, 5);
    for (const auto& edges : {std::vector{xyz}, std::vector{xy, z}}) {
      const BarostatSettings settings{.type = CellRescaling{1}, .every = 0.3, .edges = edges};
      // Many moves of single edges are rejected by the bound of the shape.
      check_shape(volume_of(scene, settings, edges.size() == 1 ? 40000 : 80000), 6);
    }
  }
}

// Without rejections the distribution errs in proportion to the interval: moves of 1/40 of the time
// constant have the error of their discretisation, below 1/40 of the width.
TEST_CASE("cell rescaling as published has the same law for short intervals") {
  const scenes::Scene scene = scenes::lattice({{"argon", 6}}, 0.4, 3, 5);
  const BarostatSettings settings{.type = CellRescaling{1, false}, .every = 0.025};
  const Volume v = volume_of(scene, settings, 400000);
  CHECK(std::abs(v.mean.value - 6) < 4 * v.mean.error + 0.025 * std::sqrt(6.0));
  CHECK(std::abs(v.variance.value - 6) < 4 * v.variance.error + 0.025 * 6);
  CHECK(v.mean.error < 0.1);
}

// The acceptance has N molecules: V^N.
TEST_CASE("Monte Carlo moves: an ideal gas has V from Gamma(N + 1, kT/P), whatever its sites") {
  for (const char* molecule : {"argon", "tip5p"}) {
    CAPTURE(std::string(molecule));
    const scenes::Scene scene = scenes::lattice({{molecule, 6}}, 0.4, 3, 5);
    for (const auto& edges : {std::vector{xyz}, std::vector{xy, z}})
      check_shape(volume_of(scene, {.type = VolumeMoves{}, .edges = edges}, 60000), 7);
  }
}

// Without the bound the shape would walk by a factor of 2 in these moves.
TEST_CASE(
    "edges that are moved separately keep their ratios within the bound, others do not count") {
  const scenes::Scene scene = scenes::lattice({{"argon", 64}}, 0.4, 3, 5);
  constexpr CoupledEdges x{true, false, false}, y{false, true, false};
  for (const BoxMoves& type : {BoxMoves(CellRescaling{1}), BoxMoves(VolumeMoves{})})
    for (const auto& edges : {std::vector{x, y, z}, std::vector{xy, z}, std::vector{z}}) {
      const BarostatSettings settings{.type = type,
                                      .pressure = pressure,
                                      .compressibility = 0.1 / pressure,
                                      .every = 0.3,
                                      .edges = edges};
      Barostat barostat(settings, kelvin, scene.bodies, 3);
      State state = scene.state;
      state.box.edge = std::cbrt(64 * kT / pressure) * Vec3<double>{1, 1.5, 1 / 1.5};
      const Vec3<double> first = state.box.edge;
      Load load(state.size());
      double widest = 1;
      const LangevinSettings maxwell{.kT = kT, .seed = 4};
      for (std::uint64_t k = 0; k < 4000; ++k) {
        refresh_momenta(state, scene.bodies, maxwell, 0, k);
        barostat.move(state, load, scenes::no_forces, k);
        const Vec3<double> s = {state.box.edge.x / first.x, state.box.edge.y / first.y,
                                state.box.edge.z / first.z};
        widest = std::max(widest, std::max({s.x, s.y, s.z}) / std::min({s.x, s.y, s.z}));
      }
      if (edges.size() == 1) {
        CHECK(barostat.memory().beyond_shape == 0);
        CHECK(widest > max_shape_change);  // fixed edges restrict no volume
      } else {
        CHECK(barostat.memory().beyond_shape > 0);
        CHECK(widest <= max_shape_change);
        CHECK(widest > 0.95 * max_shape_change);
      }
    }
}

TEST_CASE("a move scales centres of mass, keeps orientations, and returns to the bit if rejected") {
  const scenes::Scene scene = scenes::lattice({{"tip4p", 8}}, 0.4, 3, 5);
  for (const BoxMoves& type : {BoxMoves(CellRescaling{}), BoxMoves(VolumeMoves{})}) {
    // Energies that grow steeply with any change: moves are rejected unless they are small.
    double stiffness = 0;
    const auto evaluate = [&](const State& state, Load& load) {
      load = Load(state.size());
      load.van_der_waals = stiffness * std::pow(state.box.volume() - 27, 2);
    };
    const BarostatSettings settings{
        .type = type, .pressure = pressure, .compressibility = 1e-3, .edges = {xy}};
    Barostat barostat(settings, kelvin, scene.bodies, 3);
    State state = scene.state;
    Load load(state.size());
    while (!barostat.move(state, load, evaluate, barostat.memory().moves)) {
    }
    const std::uint64_t moves = barostat.memory().moves;
    const double s = state.box.edge.x / 3;
    CHECK(s != 1);
    CHECK(state.box.edge.z == 3);
    for (std::size_t i = 0; i < state.size(); ++i) {
      CHECK(state.q[i].x == doctest::Approx(s * scene.state.q[i].x).epsilon(1e-14));
      CHECK(state.q[i].z == scene.state.q[i].z);
      CHECK(state.orientation[i] == scene.state.orientation[i]);
      const double momentum = std::holds_alternative<CellRescaling>(type) ? 1 / s : 1;
      CHECK(state.p[i].y == doctest::Approx(momentum * scene.state.p[i].y).epsilon(1e-14));
    }
    stiffness = 1e9;
    const State before = state;
    CHECK_FALSE(barostat.move(state, load, evaluate, moves));
    CHECK(state.box == before.box);
    for (std::size_t i = 0; i < state.size(); ++i) {
      CHECK(state.q[i] == before.q[i]);
      CHECK(state.p[i] == before.p[i]);
    }
    CHECK(barostat.memory().moves == moves + 1);
    CHECK(barostat.memory().accepted == 1);
  }
}

TEST_CASE("a barostat has other random numbers for each seed and step") {
  const scenes::Scene scene = scenes::lattice({{"tip4p", 8}}, 0.4, 3, 5);
  for (const BoxMoves& type : {BoxMoves(CellRescaling{}), BoxMoves(VolumeMoves{})}) {
    const auto volumes = [&](std::uint64_t seed, std::uint64_t first) {
      Barostat barostat({.type = type, .pressure = pressure, .compressibility = 1e-3}, kelvin,
                        scene.bodies, seed);
      State state = scene.state;
      Load load(state.size());
      std::vector<double> all;
      for (std::uint64_t step = first; step < first + 40; ++step) {
        barostat.move(state, load, scenes::no_forces, step);
        all.push_back(state.box.volume());
      }
      return all;
    };
    CHECK(volumes(3, 0) == volumes(3, 0));
    CHECK(volumes(3, 0) != volumes(4, 0));
    CHECK(volumes(3, 0) != volumes(3, 1ull << 33));
  }
}
