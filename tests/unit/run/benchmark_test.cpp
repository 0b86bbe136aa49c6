// SPDX-License-Identifier: MIT
// The operation counts with which force evaluations are compared; times are not tested.
#include "run/benchmark/benchmark.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <utility>

#include "polhode/math/random.hpp"

using namespace polhode;

namespace {

State scattered(std::size_t bodies, const Box& box) {
  State state(bodies, box);
  Random random(7);
  for (std::size_t i = 0; i < bodies; ++i)
    for (std::size_t d = 0; d < 3; ++d) {
      Component& along = d == 0 ? state.q.x : d == 1 ? state.q.y : state.q.z;
      along[i] = (3 * random.uniform() - 1) * box.edge[d];  // unwrapped
    }
  return state;
}

std::size_t one_by_one(const State& state, double distance) {
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < state.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      pairs += norm(state.box.minimum_image(state.q[i] - state.q[j])) < distance;
  return pairs;
}

}  // namespace

TEST_CASE("pairs within a distance are counted once, in boxes of few and of many cells") {
  for (const Box& box : {Box{{2.1, 2.1, 2.1}}, Box{{2.1, 3.5, 9}}, Box{{5, 4, 3}}}) {
    const State state = scattered(300, box);
    for (const double distance : {0.3, 0.7, 1.0})
      CHECK(pairs_within(state, distance) == one_by_one(state, distance));
  }
}

TEST_CASE("a timing has the best and the median of its repeats") {
  const Timing t = timing({5, 2, 4, 3, 9});
  CHECK(t.best == 2);
  CHECK(t.median == 4);
  CHECK(t.spread() == 1);
}

TEST_CASE("the limit counts pairs within the switching range at their own cost") {
  const Limit limit{Precision::double_precision, 8, 1, {{2, 2}, {3, 3}}, {{4, 4}, {5, 5}}};
  CHECK(1e9 * limit.seconds(10, 100, false) == doctest::Approx(320));
  CHECK(1e9 * limit.seconds(10, 100, true) == doctest::Approx(540));
}

TEST_CASE("steps are timed with a molecule switch, a site switch, and the Ewald sum") {
  const ForceSettings own = benchmark_forces(Precision::mixed, 0.85);
  const auto kind = [&](const char* interactions) {
    const ForceSettings s = with_interactions(own, interactions);
    CHECK((s.precision == own.precision && s.cutoff == own.cutoff));
    return std::pair(s.truncation, s.electrostatics);
  };
  CHECK((kind("reaction field") ==
         std::pair(Truncation::molecule_switch, Electrostatics::reaction_field)));
  CHECK(
      (kind("site switch") == std::pair(Truncation::site_switch, Electrostatics::reaction_field)));
  CHECK((kind("Ewald sum") == std::pair(Truncation::site_switch, Electrostatics::pme)));
}
