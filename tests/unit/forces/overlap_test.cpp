// SPDX-License-Identifier: MIT
#include "forces/pairs/overlap.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include "../errors.hpp"
#include "scenes.hpp"

using namespace polhode;

namespace {

// The message of check_overlap for a state; empty if there is none.
std::string verdict(const Topology& topology, const State& state) {
  try {
    check_overlap(topology, state);
  } catch (const Error& e) {
    return e.what();
  }
  return {};
}

// The beginning of the expected message, from all pairs and all neighbouring images.
std::string expected(const Topology& topology, const State& state) {
  struct Point {
    std::size_t body;
    Vec3<double> r;
  };
  const Bodies bodies(topology);
  std::vector<Point> points;
  for (std::size_t i = 0; i < state.size(); ++i)
    for (const Site& site : topology.parts[bodies.part[i]].molecule.sites)
      if (site.mass > 0 || site.epsilon > 0)
        points.push_back({i, state.q[i] + to_lab(state.orientation[i], site.r)});
  for (std::size_t b = 0; b < points.size(); ++b)
    for (std::size_t a = 0; a < b; ++a) {
      if (points[a].body == points[b].body) continue;
      const double d = norm(state.box.minimum_image(points[a].r - points[b].r));
      if (d < closest_contact)
        return fmt::format("molecules {} and {} overlap: two of their sites are {:.4f} nm apart",
                           points[a].body + 1, points[b].body + 1, d);
    }
  return {};
}

}  // namespace

TEST_CASE("overlaps equal those of a sum over all pairs, in boxes of any size and shape") {
  const Topology topology{{{read_molecule("tip4p"), 30}, {read_molecule("argon"), 20}}};
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-1, 2);  // also outside of the box
  std::size_t free = 0, overlapping = 0;
  for (const Vec3<double> edge : {Vec3<double>{0.05, 0.05, 0.05},
                                  {0.2, 0.3, 0.4},
                                  {0.4, 9, 0.6},
                                  {2, 2, 2},
                                  {4, 4, 4},
                                  {0.16, 300, 40},
                                  {5000, 4000, 3000}})
    for (int trial = 0; trial < 60; ++trial) {
      State state(topology.size(), Box{edge});
      for (std::size_t i = 0; i < state.size(); ++i) {
        const double x = uniform(random), y = uniform(random), z = uniform(random);
        state.q.set(i, scaled(edge, Vec3<double>{x, y, z}));
        state.orientation.set(i, scenes::random_orientation(random));
      }
      const std::string must = expected(topology, state);
      const std::string is = verdict(topology, state);
      CAPTURE(edge.x);
      CAPTURE(trial);
      CHECK(is.substr(0, must.size()) == must);
      CHECK(is.empty() == must.empty());
      ++(must.empty() ? free : overlapping);
    }
  CHECK(free > 60);
  CHECK(overlapping > 60);
}

TEST_CASE("contacts just below and above the limit are distinguished, across every face") {
  const Topology two{{{read_molecule("argon"), 2}}};
  for (std::size_t d = 0; d < 3; ++d)
    for (const double factor : {1 - 1e-9, 1 + 1e-9}) {
      State state(2, Box{{1, 2, 3}});
      Vec3<double> a{0.5, 0.5, 0.5}, b = a;
      a[d] = 0.03;
      b[d] = state.box.edge[d] + 0.03 - factor * closest_contact;
      state.q.set(0, a);
      state.q.set(1, b);
      CAPTURE(d);
      CHECK(verdict(two, state).empty() == (factor > 1));
    }
}

TEST_CASE("a position that is not finite is refused with its molecule") {
  const Topology two{{{read_molecule("tip4p"), 2}}};
  State state(2, Box{{3, 3, 3}});
  state.q.set(1, {1, std::numeric_limits<double>::quiet_NaN(), 1});
  check_error([&] { check_overlap(two, state); }, {"molecule 2 has a position that is not finite"});
}

TEST_CASE("coinciding molecules are refused quickly") {
  const Topology topology{{{read_molecule("tip4p"), 30000}}};
  State state(topology.size(), Box{{1, 1, 1}});  // all at the same position
  CHECK(
      verdict(topology, state).starts_with("molecules 1 and 2 overlap: two of their sites are 0"));
}
