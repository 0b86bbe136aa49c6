// SPDX-License-Identifier: MIT
// Slabs of a liquid: how they are made, and the surface tension of made-up segments.
#include "run/properties/slab.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "polhode/io/topology/molecule_file.hpp"
#include "polhode/math/random.hpp"
#include "run/properties/estimates.hpp"
#include "run/properties/measure_request.hpp"
#include "run/properties/point_system.hpp"
#include "run/properties/property.hpp"
#include "run/properties/replica_file.hpp"
#include "unit/errors.hpp"

using namespace polhode;

namespace {

MeasureSettings settings_of(const char* at, const char* molecules) {
  MeasureRequest request{.system = "argon", .properties = {"surface-tension"}};
  request.molecules = {molecules, "molecules"};
  request.at = {at, "at"};
  return request.settings();
}

// SI, by CODATA 2018, independent of the units of the program.
constexpr double avogadro = 6.02214076e23;
constexpr double tension_of_model = 60e-3;  // [N/m]
constexpr double edge = 2, height = 8;      // [nm]
constexpr double noise = 300e-3;            // of a segment [N/m]

/// The density of the slab of the model, with surfaces 0.8 nm thick from 10 to 90 %: it falls on a
/// line of 1 nm around 2 nm.
double density(double z) { return 50 + 950 * std::min(1.0, std::max(0.0, 2.5 - z)); }

Replica made_up(std::uint64_t index, Random& random) {
  constexpr double to_kJ_per_mol = avogadro * 1e-3 * 1e-18;  // of 1 N/m in an area of 1 nm²
  // Slabs of different sizes, as those of replicas at constant pressure.
  const double scale = 1 + 0.01 * static_cast<double>(index);
  Replica replica{.index = index, .step = 0.003, .state = State{1, Box{{edge, edge, edge}}}};
  replica.averages.assign(30, {.sums = {1, std::vector<double>(averages_count, 1.0)},
                               .potentials = std::vector<double>(parts_of_averages, 1.0),
                               .volumes = std::vector<double>(parts_of_averages, 1.0),
                               .response = {}});
  replica.slab.state = State{1, Box{{scale * edge, scale * edge, scale * height}}};
  for (int k = 0; k < 24; ++k) {
    SlabSegment segment{.sums = {125, std::vector<double>(slab_averages_count)}, .response = {}};
    const double value = to_kJ_per_mol * (tension_of_model + noise * random.normal());
    constexpr double to_u_per_nm3 = avogadro * 1e3 * 1e-27;  // of 1 kg/m³
    const double pressure = to_kJ_per_mol * 5e5 * 1e-9;      // 5 bar
    const std::vector<double> averages{value, pressure, 1000 * to_u_per_nm3, 50 * to_u_per_nm3};
    for (std::size_t n = 0; n < averages.size(); ++n) segment.sums.sum[n] = 125 * averages[n];
    for (std::size_t bin = 0; bin < bins_of_profile; ++bin) {
      const double h = height / 2 / bins_of_profile, z = (static_cast<double>(bin) + 0.5) * h;
      segment.sums.sum.push_back(125 * density(z) * to_u_per_nm3);
    }
    segment.tangential = {25, std::vector<double>(bins_of_profile, 25 * pressure)};
    for (std::size_t bin = 45; bin < 55; ++bin)  // 0.4 nm around 2 nm, in the first slab
      segment.tangential.sum[bin] -= 25 * to_kJ_per_mol * tension_of_model / (0.4 * scale);
    for (std::size_t part = 0; part < parts_of_averages; ++part)
      segment.potentials.push_back(random.normal());
    segment.response.add({0, 1, 1, 0, 1}, averages);
    segment.response.blocks = {{segment.response.blocks.means().sum()}, 1};
    replica.slab.segments.push_back(segment);
  }
  return replica;
}

}  // namespace

TEST_CASE("a slab has two copies of the liquid in the middle of a box of twice their height") {
  const MeasureSettings settings = settings_of("90 K, 1 bar", "100");
  const PointSystem point(settings, settings.points.front());
  System system = build_system(configuration_of(point.common));
  const State liquid = system.state;
  const double L = liquid.box.edge.z;
  system.state.q.add(7, {0, 0, 5 * L});  // it has diffused through the box
  make_slab(system);
  const State& slab = system.state;
  REQUIRE(slab.size() == 200);
  CHECK(system.bodies.size() == 200);
  CHECK(slab.box == Box{{liquid.box.edge.x, liquid.box.edge.y, 4 * L}});
  for (std::size_t i = 0; i < slab.size(); ++i) {
    CHECK(slab.q[i].z >= L);
    CHECK(slab.q[i].z < 3 * L);
    const Vec3<double> moved = slab.q[i] - liquid.q[i % 100];
    CHECK(std::abs(std::remainder(moved.z, L)) < 1e-12);
  }
  CHECK(system.forces.slab_dispersion);
  CHECK(!system.forces.dispersion_correction);
}

TEST_CASE("the surface tension and the profile follow from the segments of slabs") {
  Random random(5);
  std::vector<Replica> replicas;
  for (std::uint64_t k = 0; k < 4; ++k) replicas.push_back(made_up(k, random));
  const Topology topology{{{read_molecule("spce"), 100}}};
  const Mixing mixing;
  const PointData data{topology, mixing, {300, 0}, replicas};
  const MeasuredProperty found = estimate({&property("surface-tension")}, data);
  REQUIRE(found.value.known == Known::yes);
  const double error = 300 / std::sqrt(96.0);
  // The error of an error from a number of modes.
  CHECK(std::abs(found.value.error / error - 1) < 4 / std::sqrt(2 * found.value.modes));
  CHECK(std::abs(found.value.value - 60) < 4 * error);
  CHECK(found.remark.find("2.00 nm wide; 1000") != std::string::npos);
  CHECK(found.remark.find("surfaces 0.8") != std::string::npos);
  CHECK(found.remark.find("give 500 molecules or more") != std::string::npos);
  const auto value_of = [&](const char* name) {
    return estimate({&property(name)}, data).value.value;
  };
  CHECK(value_of("saturated-liquid-density") == doctest::Approx(1000).epsilon(1e-9));
  CHECK(value_of("saturated-vapour-density") == doctest::Approx(50).epsilon(1e-9));
  CHECK(value_of("saturation-pressure") == doctest::Approx(5).epsilon(1e-9));
}

TEST_CASE("a vapour without molecules is not a density of 0") {
  Random random(5);
  std::vector<Replica> replicas{made_up(0, random), made_up(1, random)};
  for (Replica& replica : replicas)
    for (SlabSegment& segment : replica.slab.segments) segment.sums.sum[vapour_density] = 0;
  const Topology topology{{{read_molecule("spce"), 100}}};
  const Mixing mixing;
  const MeasuredProperty found = estimate({&property("saturated-vapour-density"), 0.2},
                                          {topology, mixing, {300, 0}, replicas});
  CHECK(found.value.known != Known::yes);
  CHECK(!found.reached());
  CHECK(!found.longer_helps);
  CHECK(found.obstacle.find("no molecule was in the vapour") != std::string::npos);
}

TEST_CASE("the profiles of slabs: density, pressures, and the tension up to a distance") {
  Random random(5);
  std::vector<Replica> replicas{made_up(0, random)};
  const Topology topology{{{read_molecule("spce"), 100}}};
  const Mixing mixing;
  const PointData data{topology, mixing, {300, 0}, replicas};
  const std::vector<MeasuredCurve> profile = slab_profiles(data);
  REQUIRE(profile.size() == 3);
  for (const MeasuredCurve& curve : profile) REQUIRE(curve.x.size() == bins_of_profile);
  for (std::size_t k = 0; k < bins_of_profile; ++k)
    CHECK(profile.front().value[k].value ==
          doctest::Approx(density(profile.front().x[k])).epsilon(1e-9));
  // 60 mN/m in 0.4 nm are 1500 bar.
  for (std::size_t k = 0; k < bins_of_profile; ++k)
    CHECK(std::abs(profile[1].value[k].value - (k >= 45 && k < 55 ? 1500 : 0)) < 1e-6);
  CHECK(std::abs(profile[2].value[44].value) < 1e-9);
  CHECK(profile[2].value[49].value == doctest::Approx(30).epsilon(1e-9));
  CHECK(profile[2].x[49] == doctest::Approx(2).epsilon(1e-9));
  CHECK(profile[2].value.back().value == doctest::Approx(60).epsilon(1e-9));
  // Records of earlier versions have no pressures.
  for (SlabSegment& segment : replicas.front().slab.segments) segment.tangential = {0, {}};
  CHECK(slab_profiles({topology, mixing, {300, 0}, replicas}).size() == 1);
}

TEST_CASE("the slab of a replica has the same bits in one piece and in several") {
  const MeasureSettings settings = settings_of("90 K, 1 bar", "100");
  const auto after = [&](std::size_t segments, const std::string& record) {
    return perform(settings, {0, 3, {3, 0, 0, 0, segments}, 0.02, record});
  };
  const std::string one = after(1, ""), both = after(2, "");
  CHECK(after(2, one) == both);
  const PointSystem point(settings, settings.points.front());
  const Replica replica = parse_replica(both, "record", 3, point.identity);
  CHECK(replica_bytes(replica, point.identity) == both);
  REQUIRE(replica.slab.segments.size() == 2);
  CHECK(replica.slab.state->size() == 200);
}

TEST_CASE("a slab without surfaces is an error") {
  const MeasureSettings settings = settings_of("170 K, 900 kg/m3", "100");
  const auto run = [&] { perform(settings, {0, 3, {3, 0, 0, 0, 4}, 0.02, ""}); };
  try {
    run();
    FAIL("no error");
  } catch (const RunError& e) {
    CHECK(std::string(e.what()).find("the slab has evaporated") != std::string::npos);
    CHECK(std::string(e.what()).find("lower temperature") != std::string::npos);
  }
}

TEST_CASE("a slab of charges needs electrostatics without a cutoff") {
  const Property& tension = property("surface-tension");
  const Topology water{{{read_molecule("spce"), 64}}}, argon{{{read_molecule("argon"), 64}}};
  CHECK(why_not(tension, water, {.electrostatics = Electrostatics::pme}).empty());
  CHECK(why_not(tension, argon, {}).empty());
  CHECK(why_not(tension, water, {}).find("pme") != std::string::npos);
}
