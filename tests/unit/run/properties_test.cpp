// SPDX-License-Identifier: MIT
// Measurements of properties: requests, records of replicas, second virial coefficients. With
// POLHODE_WRITE_MANUAL=1 in the environment the manual's table of properties is written.
#include <doctest/doctest.h>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "../errors.hpp"
#include "../folder.hpp"
#include "io/settings/ensemble_names.hpp"
#include "polhode/base/units.hpp"
#include "polhode/forces/force_field.hpp"
#include "polhode/io/topology/molecule_file.hpp"
#include "polhode/run/properties/measure.hpp"
#include "polhode/run/simulation/system/system.hpp"
#include "run/properties/measure_request.hpp"
#include "run/properties/point_system.hpp"
#include "run/properties/property.hpp"
#include "run/properties/replica.hpp"
#include "run/properties/replica_file.hpp"
#include "run/properties/second_virial.hpp"
#include "run/properties/target.hpp"

using namespace polhode;

namespace {

constexpr double bar = 0.0602214076;  // [kJ/mol/nm³]

/// 64 argon atoms: a segment takes some ten milliseconds.
MeasureRequest argon_request(std::vector<std::string> properties = {"density"}) {
  MeasureRequest request{.system = "argon", .properties = std::move(properties)};
  request.molecules = {"64", "molecules"};
  request.at = {"160 K, 500 bar", "at"};
  return request;
}

std::string bytes_after(const MeasureSettings& settings, std::size_t averages, std::size_t dynamics,
                        const std::string& record = "") {
  return perform(settings, {0, 3, {averages, dynamics}, 0.01, record});
}

std::string properties_table() {
  std::string table = "| property | unit | definition | source |\n| --- | --- | --- | --- |\n";
  for (const Property& p : properties())
    table += fmt::format("| `{}` | {} | {} | [[{}]] |\n", p.name, p.unit, p.definition, p.sources);
  return table;
}

}  // namespace

TEST_CASE("state points are read as they are written") {
  const auto one = state_points("298.15 K, 1 bar");
  REQUIRE(one.size() == 1);
  CHECK(one[0].temperature == 298.15);
  CHECK(one[0].pressure == doctest::Approx(bar));
  CHECK(one[0].text() == "298.15 K, 1 bar");
  CHECK(state_points("300 K")[0].pressure == doctest::Approx(bar));
  const auto range = state_points("250 K to 320 K, 8 points, 2 bar");
  REQUIRE(range.size() == 8);
  CHECK(range[1].temperature == doctest::Approx(260));
  CHECK(range[7].temperature == 320);
  CHECK(range[7].pressure == doctest::Approx(2 * bar));
  const auto pressures = state_points("300 K, 1 bar to 1001 bar, 3 points");
  CHECK(pressures[1].pressure == doctest::Approx(501 * bar));
  const StatePoint dense = state_points("86.4956 K, 1418.53 kg/m3").front();
  CHECK(dense.constant_volume());
  CHECK(dense.density == doctest::Approx(854.25).epsilon(1e-4));  // 1 u/nm³ is 1.66054 kg/m³
  CHECK(std::isnan(dense.pressure));
  CHECK(dense.text() == "86.4956 K, 1418.53 kg/m3");
  CHECK(dense.file_text() == "86.4956K-1418.53kgm3");
  CHECK(state_points("300 K, 1 g/cm3")[0].density ==
        doctest::Approx(state_points("300 K, 1000 kg/m3")[0].density).epsilon(1e-12));
  const auto densities = state_points("300 K, 0.9 g/cm3 to 1.1 g/cm3, 3 points");
  CHECK(densities[1].text() == "300 K, 1000 kg/m3");
  CHECK(!one[0].constant_volume());
  check_error([] { state_points("300 K, 1 bar, 1 g/cm3"); }, {"a pressure and a density"});
  check_error([] { state_points("300 K, 0 g/cm3"); }, {"above 0 kg/m3"});
  check_error([] { state_points("300 K, 1 parsec"); }, {"no unit 'parsec' of pressure"});
  check_error([] { state_points("1 bar"); }, {"has no temperature", "298.15 K"});
  check_error([] { state_points("300"); }, {"300"});
  check_error([] { state_points("0 K"); }, {"must be above 0 K"});
  check_error([] { state_points("250 K to 300 K"); }, {"without its number of points"});
  check_error([] { state_points("300 K, 7 points"); }, {"points without a range"});
  check_error([] { state_points("250 K to 300 K, 1 points"); }, {"from 2 to 1000"});
  check_error([] { state_points("300 K to 300 K, 3 points"); }, {"are equal"});
  check_error([] { state_points("300 K, , 1 bar"); }, {"empty part"});
  check_error([] { state_points("300 K, 310 K"); }, {"two entries of one kind"});
}

TEST_CASE("properties are requested with errors in percent or in their unit") {
  const auto list =
      requested_properties({"density", "0.1 %", "enthalpy", "0.05 kJ/mol", "viscosity"});
  REQUIRE(list.size() == 3);
  CHECK(list[0].relative);
  CHECK(list[0].error == doctest::Approx(0.001));
  CHECK(!list[1].relative);
  CHECK(list[1].error == doctest::Approx(0.05));
  CHECK(list[2].error == 0.01);
  check_error([] { requested_properties({"densty"}); }, {"no property 'densty'", "'density'"});
  check_error([] { requested_properties({"0.1 %"}); }, {"must follow the name of a property"});
  check_error(
      [] {
        requested_properties({"density", "5 %", "6 %"});
      },
      {"'6 %' must follow the name of a property"});
  check_error([] { requested_properties({"density", "1 g"}); }, {"must be in % or in kg/m3"});
  check_error([] { requested_properties({"density", "0 %"}); }, {"the error of density"});
  check_error([] { requested_properties({"density", "density"}); }, {"requested twice"});
}

TEST_CASE("a request that a system cannot meet is refused with the reason") {
  const auto refused = [](MeasureRequest request, std::initializer_list<const char*> words) {
    const Folder folder;
    request.output = {folder / "m", "output"};
    check_error([&] { measure(request.settings()); }, words);
  };
  refused(argon_request({"dielectric-constant"}),
          {"cannot be measured", "no molecule has a dipole"});
  refused(argon_request({"rotational-relaxation"}), {"atoms do not rotate"});
  MeasureRequest dense = argon_request({"pressure"});
  refused(dense, {"pressure cannot be measured", "requires constant volume", "give a density"});
  dense.at = {"160 K, 1300 kg/m3; 160 K, 500 bar", "at"};
  refused(dense, {"requires constant volume", "'160 K, 500 bar'"});
  dense.at = {"160 K, 1300 kg/m3", "at"};
  for (const char* name : {"density", "molar-volume", "compressibility", "expansivity",
                           "heat-capacity", "enthalpy-of-vaporization"}) {
    dense.properties = {name};
    refused(dense, {name, "cannot be measured", "requires constant pressure", "give a pressure"});
  }
  dense.properties = {"pressure"};
  dense.at = {"160 K, 300 kg/m3", "at"};
  refused(dense, {"'160 K, 300 kg/m3' is too low for a liquid", "at least 437 kg/m3"});
  dense.at = {"160 K, 13000 kg/m3", "at"};
  refused(dense, {"too high for a liquid", "at most"});
  MeasureRequest shards = argon_request();
  shards.shard = {"5/4", "shard"};
  refused(shards, {"shard"});
  shards.shard = {"1/9", "shard"};
  refused(shards, {"more parts than there are replicas"});
  MeasureRequest mixture = argon_request({"second-virial-coefficient"});
  mixture.system = "argon 16, krypton 16";
  refused(mixture, {"no meaning for a mixture"});
  mixture.molecules = {};
  refused(mixture, {"each pair of molecules"});
  MeasureRequest unknown = argon_request();
  unknown.system = "argn";
  refused(unknown, {"argn"});
  refused(argon_request({}), {"no property is requested"});
}

TEST_CASE("a replica has the same bits in one piece and in several") {
  const MeasureSettings settings = argon_request().settings();
  const std::string whole = bytes_after(settings, 14, 1);
  std::string pieces = bytes_after(settings, 2, 0);
  pieces = bytes_after(settings, 14, 0, pieces);
  pieces = bytes_after(settings, 14, 1, pieces);
  CHECK(pieces == whole);
}

TEST_CASE(
    "a replica at constant volume has the same bits in pieces, and is not one at a pressure") {
  MeasureRequest request = argon_request({"pressure"});
  request.at = {"160 K, 1300 kg/m3", "at"};
  const MeasureSettings settings = request.settings();
  const std::string whole = bytes_after(settings, 14, 1);
  const std::string pieces = bytes_after(settings, 14, 1, bytes_after(settings, 3, 0));
  CHECK(pieces == whole);
  // The number of this pressure in [kJ/mol/nm³] is the density in [u/nm³].
  MeasureRequest other = argon_request();
  other.at = {fmt::format("160 K, {:.17g} kJ/mol/nm3", settings.points[0].density), "at"};
  check_error([&] { bytes_after(other.settings(), 15, 1, whole); }, {"was written with other"});
  const Replica replica =
      parse_replica(whole, "r", 3, PointSystem(settings, settings.points[0]).identity);
  for (const AveragesSegment& segment : replica.averages) {
    CHECK(segment.sums.sum.size() == averages_count_at_constant_volume);
    for (const double V : segment.volumes)
      CHECK(V == doctest::Approx(64 * 39.948 / settings.points[0].density).epsilon(1e-12));
  }
  CHECK(equilibrated(replica) <= 7);
}

TEST_CASE("the first of eight segments of dynamics is repeated at half of the step") {
  MeasureRequest request = argon_request();
  CHECK(request.settings().paired_runs);
  const std::string with = bytes_after(request.settings(), 14, 1);
  request.paired_runs = {"no", "paired_runs"};
  const std::string without = bytes_after(request.settings(), 14, 1);
  CHECK(with.find("paired") != std::string::npos);
  CHECK(without.find("paired") == std::string::npos);
  CHECK(with.size() > without.size());
  request.paired_runs = {"maybe", "paired_runs"};
  check_error([&] { request.settings(); }, {"paired_runs", "must be yes or no"});
}

TEST_CASE("equilibrium of a long replica starts at the end of its transient") {
  // 300 segments of 5 parts are searched in 500 groups of 3. The potential energy falls by 20
  // deviations of the parts within 50 segments, and is found within a time constant, 10 segments.
  Replica replica{.index = 0};
  int part = 0;
  for (int k = 0; k < 300; ++k) {
    AveragesSegment segment{};
    for (std::size_t p = 0; p < parts_of_averages; ++p, ++part) {
      segment.potentials.push_back(20 * std::exp(-part / 50.0) + std::sin(0.37 * part * part));
      segment.volumes.push_back(std::cos(0.37 * part * part));
    }
    replica.averages.push_back(segment);
  }
  const double expected = 50 * std::log(20 / 0.3) / 5;  // the transient is a third of a deviation
  CHECK(static_cast<double>(equilibrated(replica)) > expected - 10);
  CHECK(static_cast<double>(equilibrated(replica)) < expected + 10);
}

TEST_CASE("a force field that receives a choice of meshes has the bits of a new one") {
  MeasureRequest request{.system = "spce", .properties = {"density"}};
  request.molecules = {"64", "molecules"};
  const MeasureSettings settings = request.settings();
  const PointSystem point(settings, settings.points[0]);
  const System system = build_system(configuration_of(point.common));
  ForceSettings forces = system.forces;
  forces.mesh.reset();
  State wider = system.state;
  for (std::size_t i = 0; i < wider.size(); ++i) wider.q.set(i, 1.5 * wider.q[i]);
  wider.box = Box{1.5 * wider.box.edge};
  ForceField first(system.topology, forces, system.state.box);
  REQUIRE(first.mesh_choice());
  ForceField next(system.topology, forces, wider.box, Workers::serial(), first.mesh_choice());
  ForceField fresh(system.topology, forces, wider.box);
  CHECK(next.settings().mesh->points == fresh.settings().mesh->points);
  CHECK(next.settings().mesh->cutoff == fresh.settings().mesh->cutoff);
  CHECK(next.settings().mesh->exponent == fresh.settings().mesh->exponent);
  CHECK(next.settings().mesh->points != first.settings().mesh->points);
  Load a(wider.size()), b(wider.size());
  next(wider, a);
  fresh(wider, b);
  CHECK(a.coulomb == b.coulomb);
  for (std::size_t i = 0; i < wider.size(); ++i) CHECK(a.f[i] == b.f[i]);
}

TEST_CASE("a pilot whose box explodes at the first trial step chooses a shorter one") {
  // With this seed, half of the maximum stable step ends in a collision after which the barostat
  // makes the box explode.
  MeasureRequest request = argon_request();
  request.seed = {"0", "seed"};
  const MeasureSettings settings = request.settings();
  Replica replica{.index = pilot};
  ReplicaSettings common = PointSystem(settings, settings.points[0]).common;
  common.max_bias = 0.002;
  REQUIRE(prepare(replica, common));
  CHECK(replica.prepared());
}

TEST_CASE("a guess of the compressibility serves only the preparation") {
  for (const char* seed : {"1", "2", "5"}) {
    MeasureRequest request{.system = "spce", .properties = {"density"}};
    request.molecules = {"64", "molecules"};
    request.at = {"300 K, 1 bar", "at"};
    request.seed = {seed, "seed"};
    const MeasureSettings settings = request.settings();
    Replica replica{.index = pilot};
    REQUIRE(prepare(replica, PointSystem(settings, settings.points[0]).common));
    // Guesses are 4 or 16 times the compressibility of water, the default. A measured
    // compressibility has an error of at most 50 %.
    CAPTURE(seed);
    CHECK(replica.compressibility < 3 * default_compressibility());
  }
}

TEST_CASE("a record that is damaged or of something else is refused") {
  const Folder folder;
  const std::string path = folder / "a.replica";
  Replica replica{.index = 2};
  CHECK(!read_replica(path, 2, "this").prepared());
  write_replica(path, replica, "this");
  CHECK(read_replica(path, 2, "this").index == 2);
  check_error([&] { read_replica(path, 1, "this"); }, {"differs from the number in the file name"});
  check_error([&] { read_replica(path, 2, "that"); }, {"other molecules"});
  std::string bytes = replica_bytes(replica, "this");
  bytes.back() = static_cast<char>(bytes.back() ^ 1);
  check_error([&] { parse_replica(bytes, path, 2, "this"); }, {"checksum", path.c_str()});
  check_error([&] { parse_replica("polhode", path, 2, "this"); }, {"not a replica file"});
  Replica uneven{.index = 2};
  uneven.dynamics.state = State(3, Box{{1, 1, 1}});
  uneven.dynamics.state->p = Vec3Column(2);
  check_error([&] { parse_replica(replica_bytes(uneven, "this"), path, 2, "this"); },
              {"columns have different lengths", "remove it", path.c_str()});
}

TEST_CASE("the second virial coefficient of Lennard-Jones atoms is that of its series") {
  // B/b₀ = −Σ 2^((2n+1)/2)/(4 n!) Γ((2n − 1)/4) T^(−(2n+1)/4) with b₀ = 2πσ³/3, T in ε/k.
  const Molecule molecule = read_molecule("argon");
  const Site& site = molecule.sites.front();
  const double b0 = 2 * units::pi * std::pow(site.sigma, 3) / 3;
  const auto series = [](double T) {
    double sum = 0;
    for (int n = 0; n < 60; ++n)
      sum -= std::pow(2, n + 0.5) / (4 * std::tgamma(n + 1)) * std::tgamma((2 * n - 1) / 4.0) *
             std::pow(T, -(2 * n + 1) / 4.0);
    return sum;
  };
  for (const double T : {0.8, 1.0, 3.418, 10.0}) {
    CAPTURE(T);
    const Estimate B = second_virial(molecule, {}, T * site.epsilon / units::boltzmann, 1);
    // Simpson's rule in steps of 0.004 nm.
    CHECK(B.value / b0 == doctest::Approx(series(T)).epsilon(1e-4).scale(1));
  }
}

TEST_CASE("the second virial coefficients of SPC/E are the published ones") {
  // −408.2 and −85.96 cm³/mol [10.1021/jp0710685, quoted with four digits].
  const Molecule water = read_molecule("spce");
  for (const auto& [T, published] : {std::pair{500.0, -408.2}, {773.0, -85.96}}) {
    const Estimate B = second_virial(water, {}, T, 4096);
    CHECK(std::abs(B.value / cm3_per_mol - published) < 4 * B.error / cm3_per_mol);
    CHECK(B.error < 0.01 * std::abs(B.value));
  }
}

TEST_CASE("the manual has the properties as their rows state them") {
  const std::string path = std::string(POLHODE_TEST_DATA) + "/../../docs/manual/measure.md";
  const std::string begin = "<!-- properties -->\n", end = "<!-- end of properties -->";
  std::ifstream in(path);
  const std::string page{std::istreambuf_iterator<char>(in), {}};
  const auto first = page.find(begin), last = page.find(end);
  REQUIRE(first != page.npos);
  REQUIRE(last != page.npos);
  const auto at = first + begin.size();
  if (std::getenv("POLHODE_WRITE_MANUAL"))
    std::ofstream(path) << page.substr(0, at) + properties_table() + page.substr(last);
  else
    CHECK(page.substr(at, last - at) == properties_table());
}

TEST_CASE("the replicas of a measurement that is stopped have the same length") {
  const Folder folder;
  MeasureRequest request = argon_request({"density", "diffusion"});
  request.output = {folder / "out", "output"};
  const MeasureSettings settings = request.settings();
  constexpr int stop_after = 40;  // pieces; four replicas have 116 before the first decision
  int reports = 0;
  Callbacks callbacks;
  callbacks.progress = [&](const Progress&) { ++reports; };
  callbacks.stop = [&] { return reports >= stop_after; };
  measure(settings, callbacks, Workers::serial(), {});
  const PointSystem system(settings, settings.points.front());
  std::vector<std::size_t> pieces;
  for (std::uint64_t k = 0; k < settings.replicas; ++k) {
    const Replica replica = read_replica(
        fmt::format("{}-160K-500bar-r{}.replica", settings.prefix, k), k, system.identity);
    pieces.push_back((replica.prepared() ? 1 : 0) + replica.averages.size() +
                     replica.dynamics.segments.size());
  }
  const auto [shortest, longest] = std::ranges::minmax(pieces);
  CHECK(longest == stop_after / settings.replicas);
  CHECK(shortest == longest);
}
