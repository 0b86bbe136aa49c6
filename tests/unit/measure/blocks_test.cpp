// SPDX-License-Identifier: MIT
// Loops in blocks: the same bits for any number of threads, and the laws of each loop.
#include "base/blocks.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/instruction_set.hpp"
#include "polhode/integrate/flows.hpp"
#include "polhode/integrate/rodrigues.hpp"
#include "polhode/measure/energy.hpp"
#include "scenes.hpp"

using namespace polhode;

namespace {

// Three blocks of the largest size, the last of which is short and does not fill a pack.
constexpr std::size_t largest_block = 2048, count = 2 * largest_block + 203;

scenes::Scene crowd() {
  return scenes::lattice({{"tip4p", count - 300}, {"co2", 100}, {"argon", 200}}, 0.4, 20, 3);
}

Load some_load(const State& state) {
  Load load(state.size());
  load.coulomb = 2;
  for (std::size_t i = 0; i < state.size(); ++i) {
    load.f.set(i, 100.0 * state.p[i]);
    load.tau.set(i, 30.0 * state.p[state.size() - 1 - i]);
  }
  return load;
}

bool same_bits(const Vec3Column& a, const Vec3Column& b) {
  return std::ranges::equal(a.x.values(), b.x.values()) &&
         std::ranges::equal(a.y.values(), b.y.values()) &&
         std::ranges::equal(a.z.values(), b.z.values());
}

bool same_bits(const State& a, const State& b) {
  const auto &s = a.orientation, &t = b.orientation;
  return same_bits(a.q, b.q) && same_bits(a.p, b.p) && same_bits(a.ell, b.ell) &&
         std::ranges::equal(s.w.values(), t.w.values()) &&
         std::ranges::equal(s.x.values(), t.x.values()) &&
         std::ranges::equal(s.y.values(), t.y.values()) &&
         std::ranges::equal(s.z.values(), t.z.values());
}

template <class Function>
void for_each_instruction_set(const Function& f) {
  const InstructionSet before = current_instruction_set();
  for (const InstructionSet instruction_set : available_instruction_sets()) {
    force_instruction_set(instruction_set);
    INFO(name(instruction_set));
    f();
  }
  force_instruction_set(before);
}

}  // namespace

TEST_CASE("blocks cover each body once") {
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{1}, std::size_t{512}, std::size_t{513}, count}) {
    std::vector<int> seen(size, 0);
    each_block(size, 512, Workers::serial(), [&](std::size_t first, std::size_t end) {
      CHECK(first % Column<double>::padded(1) == 0);
      for (std::size_t i = first; i < end; ++i) ++seen[i];
    });
    CHECK(seen == std::vector<int>(size, 1));
  }
}

TEST_CASE("flows and energies have the same bits for any number of threads") {
  for_each_instruction_set([] {
    const scenes::Scene start = crowd();
    const Load load = some_load(start.state);
    State one = start.state;
    drift(one, start.bodies, 0.003);
    kick(one, start.bodies, load, 0.002);
    displace(one, start.bodies, load, 1e-9);
    const Energies e = energies(one, start.bodies, load);
    CHECK(!same_bits(one, start.state));
    for (const int threads : {1, 2, 3}) {
      Workers workers(threads);
      State many = start.state;
      drift(many, start.bodies, 0.003, workers);
      kick(many, start.bodies, load, 0.002, workers);
      displace(many, start.bodies, load, 1e-9, workers);
      CAPTURE(threads);
      CHECK(same_bits(one, many));
      const Energies sums = energies(many, start.bodies, load, workers);
      CHECK(sums.translation == e.translation);
      CHECK(sums.rotation == e.rotation);
      CHECK(sums.total() == e.total());
    }
  });
}

// A sum of n positive terms in any order errs by less than n roundings; here the sums are at most a
// block long, and each term has a few roundings.
TEST_CASE("energies are the sums over bodies") {
  for_each_instruction_set([] {
    const scenes::Scene scene = crowd();
    const State& state = scene.state;
    long double translation = 0, rotation[3] = {0, 0, 0}, mass = 0;
    Vec3<double> momentum{};
    for (std::size_t i = 0; i < count; ++i) {
      mass += scene.bodies.m[i];
      momentum += state.p[i];
      translation += norm2(state.p[i]) * scene.bodies.inverse_m[i] / 2;
      const Vec3<double> L = to_body(state.orientation[i], state.ell[i]);
      for (std::size_t k = 0; k < 3; ++k)
        rotation[k] += L[k] * L[k] * scene.bodies.inverse_J[i][k] / 2;
    }
    translation -= norm2(momentum) / (2 * mass);  // of the centre of mass
    const Energies e = energies(state, scene.bodies, Load{});
    const double bound = (largest_block + 20) * 0x1p-53;
    const auto near = [&](double sum, long double exact) {
      return std::abs(static_cast<double>(sum - exact)) <= bound * static_cast<double>(exact);
    };
    CHECK(near(e.translation, translation));
    for (std::size_t k = 0; k < 3; ++k) CHECK(near(e.rotation[k], rotation[k]));
  });
}

// Padding does not belong to any body.
TEST_CASE("energies ignore padding") {
  for_each_instruction_set([] {
    scenes::Scene scene = crowd();
    const Energies before = energies(scene.state, scene.bodies, Load{});
    for (std::size_t i = count; i < scene.state.p.padded_size(); ++i) {
      scene.state.p.set(i, {1, 2, 3});
      scene.state.ell.set(i, {1, 2, 3});
    }
    CHECK(energies(scene.state, scene.bodies, Load{}).total() == before.total());
  });
}

// q̃ = q + c f/m and S̃ = R(c J⁻¹ S τ) S body by body, up to the roundings of a sum and of a
// product of quaternions; rotations by 1e-6 are typical of gradient kicks, those by 0.4 use the
// whole series, and those by 2 the closed form.
TEST_CASE("displace moves and turns each body by its own force and torque") {
  for_each_instruction_set([] {
    const scenes::Scene start = crowd();
    for (const double largest : {1e-6, 0.4, 2.0}) {
      Load load = some_load(start.state);
      const auto turn = [&](std::size_t i) {  // J⁻¹ S τ
        return scaled(start.bodies.inverse_J[i], to_body(start.state.orientation[i], load.tau[i]));
      };
      double max_size = 0;
      for (std::size_t i = 0; i < count; ++i) max_size = std::max(max_size, norm(turn(i)));
      const double c = largest / max_size;
      State moved = start.state;
      displace(moved, start.bodies, load, c);
      double worst_q = 0, worst_turn = 0;
      for (std::size_t i = 0; i < count; ++i) {
        const Vec3<double> step = c * start.bodies.inverse_m[i] * load.f[i];
        const Vec3<double> q = start.state.q[i] + step;
        worst_q = std::max(worst_q, norm(moved.q[i] - q) / (norm(q) + norm(step)));
        const Quaternion<double> a = start.state.orientation[i] * rodrigues(c * turn(i));
        const Quaternion<double> b = moved.orientation[i];
        worst_turn = std::max({worst_turn, std::abs(a.w - b.w), std::abs(a.x - b.x),
                               std::abs(a.y - b.y), std::abs(a.z - b.z)});
      }
      CAPTURE(largest);
      CHECK(worst_q <= 4 * 0x1p-53);
      CHECK(worst_turn <= 16 * 0x1p-53);
    }
  });
}
