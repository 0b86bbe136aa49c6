// SPDX-License-Identifier: MIT
// The coupling of a molecule in stages: energies of the stages, and free energies of made-up
// stages.
#include <doctest/doctest.h>

#include <cmath>
#include <string_view>
#include <vector>

#include "polhode/base/units.hpp"
#include "polhode/io/topology/molecule_file.hpp"
#include "polhode/math/random.hpp"
#include "run/properties/coupling.hpp"
#include "run/properties/estimates.hpp"
#include "run/properties/measure_request.hpp"
#include "run/properties/point_system.hpp"
#include "run/properties/property.hpp"
#include "run/properties/replica_file.hpp"

using namespace polhode;

namespace {

MeasureSettings coupling_settings(const char* system, const char* molecules) {
  MeasureRequest request{.system = system, .properties = {"chemical-potential"}};
  if (*molecules != '\0') request.molecules = {molecules, "molecules"};
  request.at = {"300 K, 1 bar", "at"};
  return request.settings();
}

double energy_of(const System& system, const State& state) {
  ForceField forces(system.topology, system.forces, state.box);
  Load load(state.size());
  forces(state, load);
  return load.potential();
}

constexpr std::size_t stages = 4;
constexpr double shift = 1.5;  // of the mean from stage to stage

/// Stages with the energies x²/2 + k shift x [kT], so that stage k has the free energy
/// −(k shift)²/2 and differs from the next one by shift x.
std::vector<StageSegment> made_up_segment(const CouplingPath& path, Random& random) {
  constexpr int samples = 25;
  std::vector<StageSegment> segment;
  for (std::size_t k = 0; k < stages; ++k) {
    StageSegment stage{.sums = {samples, std::vector<double>(coupling_sums)}, .response = {}};
    for (int n = 0; n < samples; ++n) {
      const double x = random.normal() - static_cast<double>(k) * shift;
      const auto fermi = [](double y) { return 1 / (1 + std::exp(y)); };
      if (k > 0) stage.sums.sum[0] += fermi(-shift * x + path[k - 1].next);
      if (k + 1 < stages) stage.sums.sum[1] += fermi(shift * x - path[k].next);
      stage.sums.sum[2] += 1;
      stage.response.add({0, 1, 1, 0, 1}, std::vector<double>(coupling_sums, 1.0));
    }
    stage.response.blocks = {{stage.response.blocks.means().sum()}, 1};
    segment.push_back(stage);
  }
  return segment;
}

/// Replicas with made-up stages, whose path has wrong estimates.
std::vector<Replica> made_up_replicas(std::uint64_t seed, double wrong_by = 0.7) {
  CouplingPath path;
  for (std::size_t k = 0; k < stages; ++k) {
    const double here = static_cast<double>(k), exact = -(2 * here + 1) * shift * shift / 2;
    path.push_back({here / 3, 0, k + 1 < stages ? exact + wrong_by : 0});
  }
  std::vector<Replica> replicas;
  for (std::uint64_t r = 0; r < 4; ++r) {
    Replica replica{.index = r, .step = 0.002, .state = State{1, Box{Vec3<double>{2, 2, 2}}}};
    Random random(seed, r);
    replica.coupled.path = path;
    for (int n = 0; n < 16; ++n) replica.coupled.segments.push_back(made_up_segment(path, random));
    replicas.push_back(replica);
  }
  return replicas;
}

SeriesEstimate made_up_potential(std::uint64_t seed) {
  const Topology topology{{{read_molecule("argon"), 64}}};
  const Mixing mixing;
  const RequestedProperty request{&property("chemical-potential")};
  return estimate(request, {topology, mixing, {300, 0.06}, made_up_replicas(seed)}).value;
}

}  // namespace

TEST_CASE("the last stage of a coupling is the whole system, and the first lacks the molecule") {
  for (const char* model : {"spce", "tip4p-2005", "argon", "benzene", "spce 1, argon 63"}) {
    CAPTURE(model);
    const bool is_mixture = std::string_view(model).find(',') != std::string_view::npos;
    MeasureSettings settings = coupling_settings(model, is_mixture ? "" : "64");
    settings.config.forces.precision = Precision::double_precision;
    const PointSystem point(settings, settings.points.front());
    Config config = configuration_of(point.common);
    config.run.minimise = true;
    System whole = build_system(config);
    if (whole.forces.electrostatics == Electrostatics::pme)
      whole.forces.mesh = ForceField(whole.topology, whole.forces, whole.state.box).settings().mesh;
    const double U = energy_of(whole, whole.state);
    CHECK(energy_of(coupled(whole, {1, 1}), whole.state) == doctest::Approx(U).epsilon(1e-12));

    System fewer = whole;
    std::vector<Topology::Part>& parts = fewer.topology.parts;
    const std::size_t last = --parts.front().count;  // the molecule that is coupled
    if (last == 0) {
      parts.erase(parts.begin());
      fewer.forces.electrostatics = Electrostatics::coulomb;
      fewer.forces.mesh.reset();
    }
    fewer.bodies = Bodies(fewer.topology);
    fewer.state = State(whole.state.size() - 1, whole.state.box);
    for (std::size_t i = 0; i < fewer.state.size(); ++i) {
      fewer.state.q.set(i, whole.state.q[i + (i >= last)]);
      fewer.state.orientation.set(i, whole.state.orientation[i + (i >= last)]);
    }
    CHECK(energy_of(coupled(whole, {}), whole.state) ==
          doctest::Approx(energy_of(fewer, fewer.state)).epsilon(1e-12));
  }
}

TEST_CASE("acceptance ratios give the free energy of Gaussian stages, with a calibrated error") {
  const double kT = units::boltzmann * 300, last = 3 * shift;
  const double exact = -kT * last * last / 2;
  constexpr int seeds = 300;
  int outside = 0;
  double squares = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const SeriesEstimate found = made_up_potential(seed);
    REQUIRE(found.known == Known::yes);
    const double deviation = (found.value - exact) / found.error;
    squares += deviation * deviation;
    outside += std::abs(deviation) > interval_factor(found, 0.99);
  }
  // Three outside are expected. A Poisson number with this mean is above 10 in 0.03 % of cases.
  CHECK(outside <= 10);
  // The mean of 300 squares has a standard deviation of √(2/300); Student's t of about 60 modes
  // adds 4 % to the mean. 4 deviations.
  CHECK(squares / seeds == doctest::Approx(1.04).epsilon(0.35));
}

// Without its fluctuations the volume cancels between the first and the last stage.
TEST_CASE("at constant volume the chemical potential is the free energy of the stages") {
  const Topology topology{{{read_molecule("argon"), 64}}};
  const Mixing mixing;
  std::vector<Replica> replicas = made_up_replicas(3);
  const StatePoint at{300, std::nan(""), 600};
  const RequestedProperty request{&property("chemical-potential")};
  const SeriesEstimate one = estimate(request, {topology, mixing, at, replicas}).value;
  REQUIRE(one.known == Known::yes);
  CHECK(one.value == doctest::Approx(made_up_potential(3).value).epsilon(1e-12));
  for (Replica& replica : replicas)
    for (std::vector<StageSegment>& segment : replica.coupled.segments) {
      segment.front().sums.sum[2] /= 3;
      segment.back().sums.sum[2] *= 3;
    }
  CHECK(estimate(request, {topology, mixing, at, replicas}).value.value ==
        doctest::Approx(one.value).epsilon(1e-12));
}

// A vapour of density ρ with coefficient B has the chemical potential ln ρ + 2 B ρ [kT] and the
// pressure ρ (1 + B ρ) [kT].
TEST_CASE("the vapour pressure is that of a vapour with the chemical potential of the liquid") {
  const Topology topology{{{read_molecule("argon"), 64}}};
  const Mixing mixing;
  const double T = 300, kT = units::boltzmann * T, pressure = 0.06;
  std::vector<Replica> replicas = made_up_replicas(3);
  constexpr double volume = 3;  // [nm³]
  for (Replica& replica : replicas) {
    replica.coupled.path.front().next -= 3;
    for (std::vector<StageSegment>& segment : replica.coupled.segments) {
      segment.front().sums.sum[2] /= volume;
      segment.back().sums.sum[2] *= volume;
    }
  }
  const auto measured = [&](const char* name) {
    const RequestedProperty request{&property(name)};
    return estimate(request, {topology, mixing, {T, pressure}, replicas}).value;
  };
  const double bar = 0.0602214076, liquid = 64 / volume;
  const double mu = measured("chemical-potential").value / kT;
  const double B = measured("second-virial-coefficient").value / 602.214076;
  const SeriesEstimate found = measured("vapour-pressure");
  const double p = found.value * bar / kT, density = (std::sqrt(1 + 4 * B * p) - 1) / (2 * B);
  CHECK(std::log(density) + 2 * B * density ==
        doctest::Approx(mu + std::log(liquid) + (p - pressure / kT) / liquid).epsilon(1e-4));
  // dp/dμ is the density of the vapour.
  CHECK(found.error * bar ==
        doctest::Approx(density * measured("chemical-potential").error).epsilon(0.02));
}

// The acceptance ratios then are nearly 1 one way and nearly 0 the other way, so their sum is near
// 1 as well.
TEST_CASE("stages without overlap are found also if the estimates of the path are wrong") {
  const Topology topology{{{read_molecule("argon"), 64}}};
  const Mixing mixing;
  const RequestedProperty request{&property("chemical-potential")};
  std::vector<Replica> replicas = made_up_replicas(3, 30);
  const MeasuredProperty found = estimate(request, {topology, mixing, {300, 0.06}, replicas});
  CHECK(found.obstacle.find("the overlap of two stages") != std::string::npos);
}

TEST_CASE("a pair of sites without a potential at a stage is left out there") {
  MeasureSettings settings = coupling_settings("krypton 1, argon 63", "");
  settings.config.forces.mixing.pairs = {{"krypton.Kr", "argon.Ar", 0.35, 1.2, {}}};
  const PointSystem point(settings, settings.points.front());
  const System whole = build_system(configuration_of(point.common));
  REQUIRE(whole.forces.mixing.pairs.size() == 1);
  CHECK(coupled(whole, {1, 1}).forces.mixing.pairs.size() == 1);
  const System without = coupled(whole, {});
  CHECK(without.forces.mixing.pairs.empty());
  CHECK(std::isfinite(energy_of(without, whole.state)));
}

TEST_CASE("replicas with different stages are not joined, and the remedy is given") {
  const Topology topology{{{read_molecule("argon"), 64}}};
  const Mixing mixing;
  std::vector<Replica> replicas = made_up_replicas(6);
  replicas[2].coupled.path[1].next += 0.1;
  const RequestedProperty request{&property("chemical-potential")};
  const MeasuredProperty none = estimate(request, {topology, mixing, {300, 0.06}, replicas});
  CHECK(none.value.known != Known::yes);
  CHECK(none.obstacle.find("different stages") != std::string::npos);
}

TEST_CASE("the ideal gas has the density of the whole system") {
  const Topology topology{{{read_molecule("argon"), 64}}};
  const Mixing mixing;
  const double T = 300, kT = units::boltzmann * T;
  std::vector<Replica> replicas = made_up_replicas(5);
  const auto measured = [&] {
    const RequestedProperty request{&property("chemical-potential")};
    return estimate(request, {topology, mixing, {T, 0.06}, replicas}).value.value;
  };
  const double before = measured();
  for (Replica& replica : replicas)
    for (std::vector<StageSegment>& segment : replica.coupled.segments) {
      segment.front().sums.sum[2] /= 3.0;  // the inverse of the volume without the molecule
      segment.back().sums.sum[2] *= 3.1;   // the volume with it
    }
  CHECK(measured() - before == doctest::Approx(kT * std::log(3.1 / 3.0)).epsilon(1e-9));
}

TEST_CASE("without a replica in equilibrium there is no free energy, and the reason is given") {
  std::vector<Replica> replicas = made_up_replicas(1);
  for (Replica& replica : replicas)
    for (int k = 0; k < 4; ++k) {
      const double drift = 100.0 * k;
      const std::vector<double> series(parts_of_averages, drift);
      replica.averages.push_back({{1, std::vector<double>(averages_count)}, series, series, {}});
    }
  const Topology topology{{{read_molecule("argon"), 64}}};
  const Mixing mixing;
  const RequestedProperty request{&property("chemical-potential")};
  const MeasuredProperty none = estimate(request, {topology, mixing, {300, 0.06}, replicas});
  CHECK(none.value.known != Known::yes);
  CHECK(none.obstacle.find("not reached equilibrium") != std::string::npos);
}

TEST_CASE("a molecule that cannot be coupled in stages is refused with the reason") {
  const Property& mu = property("chemical-potential");
  const auto why = [&](const char* model, std::size_t count) {
    return why_not(mu, Topology{{{read_molecule(model), count}}},
                   {.electrostatics = Electrostatics::pme});
  };
  CHECK(why("spce", 64).empty());
  CHECK(why("spce", 1).find("no other molecule") != std::string::npos);
  CHECK(why("na-spce", 2).find("charge of 1 e") != std::string::npos);
  Molecule table = read_molecule("argon");
  table.sites.front().law = TabulatedLaw{};
  CHECK(why_not(mu, Topology{{{table, 64}}}, {}).find("tabulated") != std::string::npos);
  Molecule bare = read_molecule("argon");
  bare.sites.front().epsilon = 0;
  CHECK(why_not(mu, Topology{{{bare, 64}}}, {}).find("no short-range") != std::string::npos);
  CHECK(why_not(mu, StatePoint{300, std::nan(""), 600}).empty());
  CHECK(!why_not(property("vapour-pressure"), StatePoint{300, std::nan(""), 600}).empty());
}

TEST_CASE("the coupling of a replica has the same bits in one piece and in several") {
  MeasureSettings settings = coupling_settings("argon", "32");
  settings.points = state_points("160 K, 500 bar");
  const CouplingPath path{{0, 0, 0.2}, {0.5, 0, 0.5}, {0.8, 0, 0.4}, {1, 0, 0}};
  const auto after = [&](std::size_t coupled, const std::string& record) {
    return perform(settings, {0, 3, {3, 0, 0, coupled}, 0.01, record, path});
  };
  const std::string one = after(1, ""), both = after(2, "");
  CHECK(after(2, one) == both);
  const PointSystem point(settings, settings.points.front());
  const Replica replica = parse_replica(both, "record", 3, point.identity);
  CHECK(replica_bytes(replica, point.identity) == both);
  CHECK(replica.coupled.path == path);
  REQUIRE(replica.coupled.segments.size() == 2);
  CHECK(replica.coupled.segments[1].size() == path.size());
  CHECK(replica.coupled.states.size() == path.size());
  const double samples =
      static_cast<double>(steps_of_coupling) / static_cast<double>(steps_of_coupling_sample);
  CHECK(replica.coupled.segments[0][0].sums.weight == samples);
}

TEST_CASE("a pilot chooses stages from nothing to the whole molecule, in order") {
  MeasureSettings settings = coupling_settings("argon", "32");
  settings.points.front().temperature = 120;
  PointSystem point(settings, settings.points.front());
  Replica first{.index = pilot};
  REQUIRE(prepare(first, point.common));
  point.common.step = first.step;
  REQUIRE(choose_stages(first, point.common));
  const CouplingPath& path = first.coupled.path;
  REQUIRE(path.size() >= 3);
  CHECK(path.front().size == 0);
  CHECK(path.back().size == 1);
  for (std::size_t k = 0; k + 1 < path.size(); ++k) CHECK(path[k].size < path[k + 1].size);
  CHECK(path.size() < possible_stages(read_molecule("argon")).size());
}
