// SPDX-License-Identifier: MIT
#include "polhode/measure/radial_distribution.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "polhode/base/error.hpp"
#include "polhode/base/units.hpp"
#include "polhode/io/topology/molecule_file.hpp"
#include "polhode/math/random.hpp"

using namespace polhode;

namespace {

// Bodies at random positions, many edges away from the box, with random orientations.
State gas(const Topology& topology, const Vec3<double>& edge, std::uint64_t seed) {
  State state(topology.size(), Box{edge});
  Random random(seed);
  for (std::size_t i = 0; i < state.size(); ++i) {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    state.q.set(i, scaled(edge, Vec3<double>{3 * x - 1, 5 * y - 2, z}));
    state.orientation.set(i, random.orientation());
  }
  return state;
}

struct PlainSite {
  Vec3<double> r;
  std::size_t body;
  std::string name;
};

// Pairs closer than `reach`, from all pairs, of sites whose names begin with the given words.
double plain_count(const State& state, const Topology& topology, const std::string& a,
                   const std::string& b, double reach) {
  std::vector<PlainSite> sites;
  std::size_t i = 0;
  for (const auto& [molecule, count] : topology.parts)
    for (const std::size_t end = i + count; i < end; ++i)
      for (const Site& site : molecule.sites)
        sites.push_back({state.q[i] + to_lab(state.orientation[i], site.r), i, site.name});
  double found = 0;
  for (const PlainSite& one : sites)
    for (const PlainSite& two : sites)
      if (one.body != two.body && one.name.starts_with(a) && two.name.starts_with(b) &&
          norm(state.box.minimum_image(one.r - two.r)) < reach)
        found += a == b ? 0.5 : 1;
  return found;
}

}  // namespace

// Shells of a simple cubic lattice: 6 neighbours at a, 12 at a√2, 8 at a√3, across periodic
// boundaries.
TEST_CASE("a cubic lattice has its neighbour shells") {
  const std::size_t n = 6;
  const double a = 0.311, edge = a * n;
  const Topology topology{{{read_molecule("argon"), n * n * n}}};
  State state(n * n * n, Box{{edge, edge, edge}});
  for (std::size_t i = 0; i < state.size(); ++i)
    state.q.set(i, Vec3<double>{a * (0.3 + static_cast<double>(i % n)),
                                a * (0.7 + static_cast<double>(i / n % n)) - edge,
                                a * (0.1 + static_cast<double>(i / n / n)) + 7 * edge});
  RadialDistribution radial(topology, {site_pairs(topology), 0.9, 0.002});
  radial.add(state);
  radial.add(state);
  const std::vector<double> n_of_r = radial.coordination(0);
  const auto within = [&](double r) { return n_of_r[static_cast<std::size_t>(r / 0.002)]; };
  CHECK(within(0.99 * a) == 0);
  CHECK(within(1.01 * a) == doctest::Approx(6).epsilon(1e-12));
  CHECK(within(1.42 * a) == doctest::Approx(18).epsilon(1e-12));
  CHECK(within(1.74 * a) == doctest::Approx(26).epsilon(1e-12));
  const auto k = static_cast<std::size_t>(a / 0.002);
  const double low = static_cast<double>(k) * 0.002, high = low + 0.002;
  const double shell = 4 * units::pi / 3 * (high * high * high - low * low * low);
  const double pairs = 216.0 * 215 / 2 / (edge * edge * edge);
  CHECK(radial.g(0)[k].value == doctest::Approx(216 * 3 / (pairs * shell)).epsilon(1e-9));
  CHECK(radial.g(0)[k].error == doctest::Approx(0).scale(1e-9));
}

TEST_CASE("a pair of sites is of two molecules") {
  const Topology water{{{read_molecule("tip4p"), 3}, {read_molecule("na-tip4p-ew"), 1}}};
  const std::vector<SitePair> some = {
      {"OW", "OW"}, {"OW", "HW"}, {"OW", "Na"}, {"HW", "HW"}, {"HW", "Na"}};
  CHECK(site_pairs(water) == some);
  CHECK(count_pairs(water, {"OW", "OW"}) == 3);
  CHECK(count_pairs(water, {"OW", "HW"}) == 3 * 2 * 2);
  CHECK(count_pairs(water, {"HW", "HW"}) == 3 * 4);
  CHECK(count_pairs(water, {"Na", "Na"}) == 0);
  CHECK(site_pairs({{{read_molecule("tip4p"), 1}}}).empty());
}

// The number of pairs of an ideal gas in a shell has a Poisson distribution: g is 1 within four
// standard errors in wide bins, and the scatter of the bins is as expected: 25 bins determine it to
// 14 %, so four times that.
TEST_CASE("g of a random gas is 1 within Poisson errors") {
  const Topology topology{{{read_molecule("argon"), 300}}};
  const Vec3<double> edge{3, 3.5, 4};
  RadialDistribution radial(topology, {site_pairs(topology), 1.0, 0.04});
  const std::uint64_t frames = 60;
  for (std::uint64_t frame = 0; frame < frames; ++frame) radial.add(gas(topology, edge, frame));
  double chi2 = 0;
  for (std::size_t k = 0; k < radial.bins(); ++k) {
    const double low = 0.04 * static_cast<double>(k), high = low + 0.04;
    const double expected = static_cast<double>(frames) * 300 * 299 / 2 * 4 * units::pi / 3 *
                            (high * high * high - low * low * low) / (3 * 3.5 * 4);
    const double off = (radial.g(0)[k].value - 1) * std::sqrt(expected);
    CHECK(std::abs(off) < 4);
    chi2 += off * off / static_cast<double>(radial.bins());
  }
  CHECK(chi2 == doctest::Approx(1).epsilon(4 * std::sqrt(2.0 / 25)));
}

// Compared with all pairs: like and unlike names, several sites per name, a mixture; boxes of one,
// two or more cells along an edge, and of fewer than would fit if there are few sites. Threads
// change nothing.
TEST_CASE("pairs of sites are counted as by a plain sum") {
  const Topology topology{{{read_molecule("tip4p"), 40}, {read_molecule("na-tip4p-ew"), 9}}};
  const std::vector<SitePair> pairs = {{"OW", "OW"}, {"OW", "HW"}, {"HW", "HW"}, {"HW1", "HW"},
                                       {"Na", "OW"}, {"MW", "Na"}, {"OW", "Na"}};
  const std::vector<std::pair<Vec3<double>, double>> boxes = {
      {{1.3, 1.4, 1.2}, 0.6}, {{2.9, 1.25, 1.9}, 0.6}, {{60, 40, 50}, 12}, {{600, 40, 50}, 4}};
  for (const auto& [edge, reach] : boxes) {
    const State state = gas(topology, edge, 5);
    const double volume = edge.x * edge.y * edge.z;
    RadialDistribution radial(topology, {pairs, reach, reach / 50}), many = radial;
    Workers workers(3);
    radial.add(state);
    many.add(state, workers);
    for (std::size_t p = 0; p < pairs.size(); ++p) {
      CAPTURE(pairs[p][0]);
      CAPTURE(pairs[p][1]);
      const bool like = pairs[p][0] == pairs[p][1];
      const double sites = pairs[p][0].starts_with("H") && pairs[p][0] != "HW1" ? 80
                           : pairs[p][0] == "Na"                                ? 9
                                                                                : 40;
      const double expected =
          plain_count(state, topology, pairs[p][0], pairs[p][1], reach) * (like ? 2 : 1) / sites;
      CHECK(radial.coordination(p).back() == doctest::Approx(expected).epsilon(1e-12));
      for (std::size_t k = 0; k < radial.bins(); ++k)
        CHECK(radial.g(p)[k].value == many.g(p)[k].value);
    }
    // Unlike pairs: 9 sodium ions and 40 oxygens form 360 pairs.
    double counted = 0;
    for (std::size_t k = 0; k < radial.bins(); ++k) {
      const double low = reach / 50 * static_cast<double>(k), high = low + reach / 50;
      counted += radial.g(4)[k].value * 360 * 4 * units::pi / 3 *
                 (high * high * high - low * low * low) / volume;
    }
    CHECK(counted == doctest::Approx(plain_count(state, topology, "Na", "OW", reach)));
  }
}

TEST_CASE("unknown site names, and a maximum distance above half of the box, are refused") {
  const Topology topology{{{read_molecule("tip4p"), 8}}};
  CHECK_THROWS_WITH_AS(RadialDistribution(topology, {{{"OW", "HX"}}, 0.5, 0.002}),
                       doctest::Contains("no site is named 'HX'"), Error);
  RadialDistribution radial(topology, {{{"OW", "OW"}}, 0.6, 0.002});
  CHECK_THROWS_WITH_AS(radial.add(gas(topology, {1.1, 2, 2}, 1)),
                       doctest::Contains("more than half of the shortest box edge (1.1000 nm)"),
                       Error);
}

// A cubic lattice of edge a in motion, rms a/20: the first shell, of 6 sites, ends between a and
// the next one at a√2. Within 1.05 a, g still falls.
TEST_CASE("a shell ends at a minimum of g, and not at the end of its range") {
  const std::size_t n = 6;
  const double a = 0.311, edge = a * n;
  const Topology topology{{{read_molecule("argon"), n * n * n}}};
  for (const double cutoff : {1.05 * a, 1.45 * a}) {
    RadialDistribution radial(topology, {site_pairs(topology), cutoff, 0.005});
    Random random(3);
    State state(n * n * n, Box{{edge, edge, edge}});
    for (int frame = 0; frame < 20; ++frame) {
      for (std::size_t i = 0; i < state.size(); ++i)
        state.q.set(i, a * Vec3<double>{static_cast<double>(i % n) + random.normal() / 20,
                                        static_cast<double>(i / n % n) + random.normal() / 20,
                                        static_cast<double>(i / n / n) + random.normal() / 20});
      radial.add(state);
    }
    const auto peak = radial.first_peak(0);
    REQUIRE(peak);
    CHECK(peak->position.value == doctest::Approx(a).epsilon(0.03));
    REQUIRE(peak->shell.has_value() == (cutoff > 1.4 * a));
    if (!peak->shell) continue;
    CHECK(peak->shell->end.value > 1.1 * a);
    CHECK(peak->shell->end.value < 1.35 * a);
    CHECK(peak->shell->coordination.value == doctest::Approx(6).epsilon(0.02));
  }
}
