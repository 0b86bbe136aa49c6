// SPDX-License-Identifier: MIT
// State points that are not liquids, with configurations made up here.
#include "run/properties/phases.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "polhode/base/error.hpp"
#include "polhode/io/topology/molecule_file.hpp"
#include "polhode/math/random.hpp"
#include "run/properties/measure_request.hpp"

using namespace polhode;

namespace {

constexpr double edge = 3;
constexpr std::size_t molecules = 512;

/// Molecules at random positions in the first part of the box along x.
State random_state(double part) {
  State state(molecules, Box{Vec3<double>{edge, edge, edge}});
  Random random(5, 1);
  for (std::size_t i = 0; i < molecules; ++i)
    state.q.set(i,
                {part * edge * random.uniform(), edge * random.uniform(), edge * random.uniform()});
  return state;
}

StatePoint point() { return state_points("100 K, 600 kg/m3").front(); }

void check(const State& state) {
  LongestWaves waves;
  waves.add(state);
  check_one_phase(waves, molecules, point());
}

template <class Action>
std::string message(Action action) {
  try {
    action();
  } catch (const RunError& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a slab of liquid has a large structure factor at the longest wavelength") {
  LongestWaves gas, slab;
  gas.add(random_state(1));
  slab.add(random_state(0.5));
  // Independent positions have an exponentially distributed structure factor of mean 1 along each
  // axis: above 4 as the mean of three axes in 1 of 2000 cases.
  CHECK(gas.mean() < 4);
  // Half of the box: N (2/π)² along one axis, and two axes of mean 1. The first has a relative
  // standard deviation of 2 √((1 − (2/π)²)/2N)/(2/π) = 8 %.
  const double expected = (molecules * std::pow(2 / 3.14159265, 2) + 2) / 3;
  CHECK(slab.mean() == doctest::Approx(expected).epsilon(0.3));
  check(random_state(1));
  const std::string text = message([] { check(random_state(0.5)); });
  for (const char* part : {"at 100 K, 600 kg/m3 the molecules separate into two phases",
                           "give the density of the liquid", "higher temperature"})
    CHECK(text.find(part) != text.npos);
}

TEST_CASE("molecules that stay where they are, are a solid") {
  const State first = random_state(1);
  const double spacing = edge / std::cbrt(molecules);
  const Bodies argon(Topology{{{read_molecule("argon"), molecules}}});
  const auto moved_by = [&](double displacement, double time = 100) {
    State later = first;
    later.box = Box{Vec3<double>{1.1 * edge, 1.1 * edge, 1.1 * edge}};  // scaling is no motion
    Random random(5, 2);
    for (std::size_t i = 0; i < molecules; ++i) {
      const double sign = random.uniform() < 0.5 ? 1 : -1;
      // Images are the same molecule.
      later.q.set(i, 1.1 * first.q[i] + Vec3<double>{sign * displacement, 1.1 * edge, 0});
    }
    check_motion(later, argon, in_fractions(first), time, point());
  };
  moved_by(1.1 * spacing * 0.26);
  const std::string text = message([&] { moved_by(1.1 * spacing * 0.24); });
  for (const char* part :
       {"have moved by only", "in 100 ps", "the system is a solid", "higher temperature"})
    CHECK(text.find(part) != text.npos);
  check_motion(first, argon, {}, 100, point());  // a record of an earlier version

  // At 100 K argon has an rms speed of √(3 · 0.8314/39.948) = 0.25 nm/ps: 4.1 nm, ten spacings, in
  // 17 ps.
  const std::string brief = message([&] { moved_by(1.1 * spacing * 0.24, 1); });
  for (const char* part : {"in 1 ps, which is too short to distinguish a liquid from a solid",
                           "would move by 0.25 nm, and 4.1 nm are needed", "longer time step"})
    CHECK(brief.find(part) != brief.npos);
  CHECK(message([&] { moved_by(1.1 * spacing * 0.24, 16); }).find("too short") != text.npos);
  CHECK(message([&] { moved_by(1.1 * spacing * 0.24, 17); }).find("is a solid") != text.npos);
}
