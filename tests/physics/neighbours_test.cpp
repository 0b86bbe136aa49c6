// SPDX-License-Identifier: MIT
// The neighbour list: every pair in range once, whole packs, and no pair missed while bodies move.
#include <doctest/doctest.h>

#include <array>
#include <map>

#include "forces/pairs/neighbours.hpp"
#include "instruction_sets.hpp"
#include "physics/force_laws.hpp"
#include "polhode/integrate/integrator.hpp"
#include "polhode/integrate/schemes.hpp"

using namespace polhode;

namespace {

struct ListCase {
  std::string name;
  std::vector<std::pair<std::string, std::size_t>> parts;
  Vec3<double> box;
  ForceSettings settings;
};

scenes::Scene scene_of(const ListCase& c, unsigned seed = 21) {
  Topology topology;
  for (const auto& [name, count] : c.parts) topology.parts.push_back({read_molecule(name), count});
  scenes::Scene scene = scenes::spread(topology, c.box, seed);
  for (std::size_t i = 0; i < scene.state.size(); ++i) {  // some start outside by several edges
    const Vec3<double> edges{double(i % 7) - 3, double(i % 4) - 2, double(i % 11) - 5};
    if (i % 3 == 1) scene.state.q.add(i, scaled(edges, c.box));
  }
  return scene;
}

ForceSettings law(Truncation truncation, double cutoff, double switch_from, double skin) {
  return {truncation, cutoff, switch_from, 2, Electrostatics::reaction_field, 78.5, skin};
}

// Few and many molecules, and boxes just large enough for two cutoffs, or for a cutoff and two
// molecular radii.
std::vector<ListCase> list_cases() {
  using enum Truncation;
  std::vector<ListCase> cases;
  for (const std::size_t n : {1u, 2u, 3u, 63u, 64u, 65u, 216u, 700u}) {
    const double edge = std::max(1.3, 0.31 * std::cbrt(double(n)));
    cases.push_back({std::to_string(n) + " waters",
                     {{"tip4p", n}},
                     {edge, edge, edge},
                     law(molecule_switch, 0.6, 0.5, 0.05)});
  }
  cases.push_back({"a box of twice the cutoff",
                   {{"tip4p", 60}},
                   {1.3, 1.3, 1.3},
                   law(molecule_switch, 0.6499, 0.5, 0.06)});
  const double extent = read_molecule("benzene").extent();
  for (const Truncation truncation : {site_switch, site_shift})
    cases.push_back({"a box of the cutoff and two benzenes",
                     {{"benzene", 4}},
                     {1.0, 1.01, 1.02},
                     law(truncation, 0.99 - 2 * extent, 0.3, 0.05)});
  for (const Truncation truncation : {molecule_switch, site_switch}) {
    cases.push_back({"a long box",
                     {{"tip4p", 100}, {"argon", 50}},
                     {14, 1.3, 1.4},
                     law(truncation, 0.6, 0.5, 0.05)});
    cases.push_back({"a flat box",
                     {{"tip4p", 100}, {"argon", 50}},
                     {4.1, 1.25, 3.7},
                     law(truncation, 0.6, 0.5, 0.05)});
    cases.push_back({"three types",
                     {{"tip4p", 90}, {"co2", 40}, {"argon", 77}},
                     {1.9, 2.3, 2.1},
                     law(truncation, 0.8, 0.7, 0.08)});
  }
  return cases;
}

// A pair: the body with the lower index, the other one, and the image of the latter in box edges,
// bodies wrapped into the box as when the list was built.
using Pair = std::array<int, 5>;

// How often each pair is listed, and how often as one inside the switching distance.
struct Listed {
  std::map<Pair, int> times, inside;
  std::size_t nowhere = 0;

  explicit Listed(const NeighbourList& list) {
    const Slots& slots = list.slots();
    for (const ListChunk& chunk : list.chunks())
      for (std::uint32_t slot = chunk.first; slot < chunk.end; ++slot)
        for (std::size_t p = chunk.part; p < slots.parts.size(); ++p) {
          const ListChunk::Row& row = chunk.row(slot, p, slots.parts.size());
          CHECK((row.truncated - row.begin) % list.width() == 0);
          CHECK((row.end - row.truncated) % list.width() == 0);
          for (std::uint32_t k = row.begin; k < row.end; ++k) {
            const Neighbour n(chunk.entries[k]);
            if (n.image() == Neighbour::nowhere) {
              CHECK(k >= row.truncated);  // such a pair has a partner
              ++nowhere;
              continue;
            }
            CHECK(n.slot() >= slots.parts[p].first);
            CHECK(n.slot() < slots.parts[p].end());
            const Pair pair = pair_of(slots.body[slot], slots.body[n.slot()], n.image());
            ++times[pair];
            if (k < row.truncated) ++inside[pair];
          }
        }
  }

  static Pair pair_of(std::uint32_t a, std::uint32_t b, const Neighbour::Image& e) {
    return a < b ? Pair{int(a), int(b), e.x, e.y, e.z} : Pair{int(b), int(a), -e.x, -e.y, -e.z};
  }
};

// Visits all pairs and images: visit(pair, distance now, part of one, part of the other).
template <class Visit>
void all_pairs(const NeighbourList& list, const State& state, const Bodies& bodies,
               const Visit& visit) {
  const Slots& slots = list.slots();
  std::vector<Vec3<double>> place(
      state.size());  // now, relative to that in the box when the list was built
  for (const Slots::Part& part : slots.parts)
    for (std::uint32_t s = part.first; s < part.end(); ++s)
      place[slots.body[s]] = slots.place[s] + (state.q[slots.body[s]] - slots.built_at[s]);
  for (std::uint32_t i = 0; i < state.size(); ++i)
    for (std::uint32_t j = i + 1; j < state.size(); ++j)
      for (int image = 0; image < 27; ++image) {
        const Neighbour::Image e{image % 3 - 1, image / 3 % 3 - 1, image / 9 - 1};
        const Vec3<double> edges{double(e.x), double(e.y), double(e.z)};
        visit(Listed::pair_of(i, j, e), norm(place[j] - place[i] + scaled(edges, state.box.edge)),
              bodies.part[i], bodies.part[j]);
      }
}

// Centres of two types may be so much farther apart than their sites.
double reach_of(const ListCase& c, const scenes::Scene& scene, std::size_t a, std::size_t b) {
  if (c.settings.truncation == Truncation::molecule_switch) return 0;
  double reach = 0;
  for (const Site& one : scene.topology.parts[a].molecule.sites)
    for (const Site& other : scene.topology.parts[b].molecule.sites)
      if ((one.charge != 0 && other.charge != 0) ||
          (one.has_short_range() && other.has_short_range()))
        reach = std::max(reach, norm(one.r) + norm(other.r));
  return reach;
}

// The skin is shorter where the box leaves less.
double skin_of(const NeighbourList& list) { return 2 * std::sqrt(list.allowed2()); }

}  // namespace

// Positions are compared in fixed point and float, which a margin of 1e-5 nm covers: pairs up to
// that far beyond the range may be listed, but none within it may be missed, and those inside the
// switching distance are closer than it by the skin, whatever the rounding.
TEST_CASE("every pair in range is listed once, in whole packs") {
  for (const ListCase& c : list_cases()) {
    CAPTURE(c.name);
    const scenes::Scene scene = scene_of(c);
    for_each_instruction_set([&] {
      for (const std::size_t width : {1u, 4u, 16u}) {
        CAPTURE(width);
        NeighbourList list(scene.topology, c.settings, scene.state.box);
        list.build(scene.state, width);
        const Listed listed(list);
        const double skin = skin_of(list);
        std::size_t expected = 0, wrong = 0, too_early = 0, inner = 0, found = 0, all = 0;
        all_pairs(list, scene.state, scene.bodies,
                  [&](const Pair& pair, double r, std::size_t a, std::size_t b) {
                    const double extent = reach_of(c, scene, a, b);
                    const double range = c.settings.cutoff + extent + skin;
                    if (r > range + 2e-5) return;
                    const auto at = listed.times.find(pair);
                    const int times = at == listed.times.end() ? 0 : at->second;
                    found += std::size_t(times);
                    wrong += times > 1 || (times == 0 && r < range);
                    expected += r < range;
                    const double from = c.settings.truncation == Truncation::site_shift
                                            ? 0
                                            : c.settings.switch_from - extent - skin;
                    too_early += listed.inside.contains(pair) && r >= from;
                    inner += r < from;
                  });
        CHECK(wrong == 0);
        CHECK(too_early == 0);
        for (const auto& [pair, times] : listed.times) all += std::size_t(times);
        CHECK(found == all);  // none beyond the range, no body with itself
        CHECK((scene.state.size() < 60 || expected > scene.state.size()));
        CHECK(list.lanes() == all + listed.nowhere);
        if (width == 1) {  // nothing is left over
          CHECK(listed.nowhere == 0);
          CHECK(listed.inside.size() <= inner);
          CHECK(double(listed.inside.size()) >= 0.99 * double(inner));
        }
      }
    });
  }
}

// A row hands over partners that do not fill a pack, unless none of them comes later in its chunk:
// so with rows of about 70 partners only the last few rows of a chunk leave lanes empty.
TEST_CASE("nearly all lanes of the list of a liquid are filled, for every pack width") {
  const ListCase water{"",
                       {{"tip4p", 4096}},
                       {4.97, 4.97, 4.97},
                       {.cutoff = 1.0, .switch_from = 0.85, .skin = 0.05}};
  scenes::Scene scene = scene_of(water);
  for (std::size_t i = 0; i < scene.state.size();
       ++i)  // displaced from the lattice by about 0.1 nm
    scene.state.q.add(i, 0.3 / scene.bodies.m[i] * scene.state.p[i]);
  NeighbourList list(scene.topology, water.settings, scene.state.box);
  std::size_t pairs = 0;
  for (const std::size_t width : {1u, 2u, 4u, 8u, 16u}) {
    CAPTURE(width);
    list.build(scene.state, width);
    std::size_t filled = 0;
    for (const ListChunk& chunk : list.chunks())
      for (const std::uint32_t word : chunk.entries)
        filled += Neighbour(word).image() != Neighbour::nowhere;
    if (width == 1) pairs = filled;
    CHECK(filled == pairs);
    CHECK(double(filled) >= 0.95 * double(list.lanes()));
    CHECK(list.lanes() % width == 0);
  }
  // 4π/3 (1.05 nm)³ at the density of a water in 0.03 nm³, each pair once; structure is 2 % of it
  const double ideal = 4096.0 * 4096 / 2 / std::pow(4.97, 3) * 4.18879 * std::pow(1.05, 3);
  CHECK(double(pairs) == doctest::Approx(ideal).epsilon(0.02));
}

// A pair that comes into range between two rebuilds must be in the list; forces show this only if
// they are large, so the list itself is checked. Forces: in double up to rounding of the largest,
// in float up to three times the rms from rounding of terms and positions, times the range for
// torques.
TEST_CASE("the neighbour list misses no pair in long runs at high temperature") {
  for (const ListCase& c : list_cases()) {
    CAPTURE(c.name);
    const bool large = scene_of(c).state.size() > 300;
    for_each_instruction_set([&] {
      if (large && current_instruction_set() != available_instruction_sets().back()) return;
      for (const Precision precision : {Precision::double_precision, Precision::mixed}) {
        CAPTURE(int(precision));
        scenes::Scene scene = scene_of(c, 22);
        for (std::size_t i = 0; i < scene.state.size(); ++i)
          scene.state.p.set(i, 3.0 * scene.state.p[i]);  // 2700 K
        ForceSettings settings = c.settings;
        settings.precision = precision;
        ForceField forces(scene.topology, settings, scene.state.box);
        Integrator integrator(schemes[1], scene.bodies, forces);
        std::size_t missed = 0, seen = 0;
        double extent = 0;  // of any site from a centre
        for (const auto& part : scene.topology.parts)
          extent = std::max(extent, part.molecule.extent());
        for (int k = 0; k < (large ? 4 : 8); ++k) {
          integrator.advance(scene.state, 0.0003, 17, false);
          const Load& load = integrator.load(scene.state);
          const auto exact =
              reference_load(scene.topology, settings, scene.state.box, scenes::poses(scene.state));
          if (precision == Precision::double_precision) {
            CHECK(largest_difference(load.f, exact.f) <= 1e-12 * largest(load.f));
            CHECK(largest_difference(load.tau, exact.tau) <= 1e-12 * largest(load.f));
          } else {
            const Terms terms = terms_of(scene, settings);
            const double rounding = 3 * std::sqrt(terms.f2 + terms.f2_of_places);
            CHECK(rms_distance(load.f, exact.f) <= rounding);
            CHECK(rms_distance(load.tau, exact.tau) <= extent * rounding);
          }
          const Listed listed(forces.neighbours());
          all_pairs(forces.neighbours(), scene.state, scene.bodies,
                    [&](const Pair& pair, double r, std::size_t a, std::size_t b) {
                      if (r >= c.settings.cutoff + reach_of(c, scene, a, b)) return;
                      ++seen;
                      missed += !listed.times.contains(pair);
                    });
          for (const auto& [pair, times] : listed.inside) missed += times != 1;
        }
        CHECK(missed == 0);
        if (scene.state.size() >= 60) {
          CHECK(seen > 8 * scene.state.size());
          CHECK(forces.neighbours().rebuilds() > 2);
        }
      }
    });
  }
}

// Bodies hundreds of nm apart: the boxes of the tree are as large as the box.
TEST_CASE("the list of a sparsely filled box misses no pair") {
  for (const auto& [n, cutoff] :
       {std::pair<std::size_t, double>{8, 1.0}, {60, 120.0}, {300, 90.0}}) {
    const ListCase c{"",
                     {{"argon", n}, {"n2", 8}},
                     {400, 300, 500},
                     law(Truncation::molecule_switch, cutoff, 0.9 * cutoff, 0.1 * cutoff)};
    const scenes::Scene scene = scene_of(c);
    NeighbourList list(scene.topology, c.settings, scene.state.box);
    list.build(scene.state, 4);
    const Listed listed(list);
    const double range = cutoff;  // a lambda of clang++ 14 cannot capture a structured binding
    std::size_t wrong = 0, near = 0;
    all_pairs(list, scene.state, scene.bodies,
              [&](const Pair& pair, double r, std::size_t, std::size_t) {
                if (r >= range) return;
                ++near;
                wrong += !listed.times.contains(pair) || listed.times.at(pair) != 1;
              });
    CHECK(wrong == 0);
    CHECK((near > 0) == (cutoff > 1));
  }
}
