// SPDX-License-Identifier: MIT
// When runs of a measurement begin and end.
#include "run/properties/schedule.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "polhode/io/topology/molecule_file.hpp"
#include "polhode/math/random.hpp"
#include "run/properties/estimates.hpp"
#include "run/properties/measure_request.hpp"
#include "run/properties/property.hpp"

using namespace polhode;

namespace {

MeasureSettings request_of(const std::vector<std::string>& properties, const char* at) {
  MeasureRequest request{.system = "argon", .properties = properties};
  request.at = {at, "at"};
  return request.settings();
}

/// Replicas whose volumes scatter by 1 % from segment to segment.
std::vector<Replica> made_up(std::size_t segments) {
  Random random(3);
  std::vector<Replica> replicas;
  for (std::uint64_t k = 0; k < 4; ++k) {
    Replica replica{.index = k, .step = 0.01, .state = State{1, Box{Vec3<double>{2, 2, 2}}}};
    for (std::size_t n = 0; n < segments; ++n) {
      AveragesSegment segment{.sums = {125, std::vector<double>(averages_count)}, .response = {}};
      const double V = 8 * (1 + 0.01 * random.normal());
      segment.sums.sum[volume] = 125 * V;
      segment.potentials.assign(parts_of_averages, random.normal());
      segment.volumes.assign(parts_of_averages, V);
      replica.averages.push_back(segment);
    }
    replicas.push_back(replica);
  }
  return replicas;
}

}  // namespace

TEST_CASE("averages come first, and dynamics with a volume that is precise enough") {
  const Topology topology{{{read_molecule("argon"), 64}}};
  const Mixing mixing;
  Target target;
  target[MeasuredIn::averages] = 24;
  // The mean volume of 96 segments has a relative error of 0.1 %, five of which are 0.5 %.
  const std::vector<Replica> replicas = made_up(24);
  const PointData data{topology, mixing, {160, 30}, replicas};
  const auto why_not_yet = [&](const char* error) {
    const MeasureSettings settings = request_of({"diffusion", error}, "160 K, 500 bar");
    return Schedule(settings).why_not_yet(target, data);
  };
  CHECK(why_not_yet("4 %").empty());  // a third is 1.3 %
  CHECK(why_not_yet("0.5 %").find("an error of 0.033 %, and it has 0.") != std::string::npos);
  const MeasureSettings slab = request_of({"surface-tension", "0.5 %"}, "160 K, 500 bar");
  CHECK(Schedule(slab).why_not_yet(target, data).empty());  // the volume of a slab is not kept
  target[MeasuredIn::averages] = 64 * 24;
  CHECK(why_not_yet("0.5 %").empty());  // an end to it
}

TEST_CASE("an error from the means of replicas alone is not continued without end") {
  MeasureSettings settings = request_of({"diffusion", "1 %"}, "160 K, 500 bar");
  settings.replicas = 8;
  const Schedule schedule(settings);
  Target target = schedule.first();
  MeasuredProperty m{.request = settings.properties.front(), .value = {6, 0.2, Known::yes, 40}};
  target[MeasuredIn::dynamics] = 64 * 4;
  CHECK(schedule.continues(m, target));
  m.value.modes = 7;
  CHECK(!schedule.continues(m, target));
  target[MeasuredIn::dynamics] = 64;
  CHECK(schedule.continues(m, target));
}

TEST_CASE("a property without a value is not continued without end") {
  const MeasureSettings settings = request_of({"rotational-relaxation", "5 %"}, "160 K, 500 bar");
  const Schedule schedule(settings);
  Target target = schedule.first();
  CHECK(target[MeasuredIn::averages] == 24);
  CHECK(target[MeasuredIn::dynamics] == 4);
  MeasuredProperty m{.request = settings.properties.front(), .value = {std::nan("")}};
  m.obstacle = "it does not relax";
  int rounds = 0;
  while (rounds < 1000 && schedule.next(target, {m}, true)) ++rounds;
  CHECK(target[MeasuredIn::dynamics] >= 64 * 4);
  CHECK(target[MeasuredIn::dynamics] < 1.5 * 64 * 4 + 1);
  m.longer_helps = false;
  target = schedule.first();
  CHECK(!schedule.next(target, {m}, true));
  CHECK(target == schedule.first());
}

TEST_CASE("dynamics with different time steps are not joined") {
  const Topology topology{{{read_molecule("argon"), 64}}};
  const Mixing mixing;
  std::vector<Replica> replicas = made_up(24);
  replicas[2].step = 0.005;
  const MeasuredProperty found =
      estimate({&property("diffusion")}, {topology, mixing, {160, 30}, replicas});
  CHECK(found.obstacle.find("different time steps") != std::string::npos);
  CHECK(!found.longer_helps);
}
