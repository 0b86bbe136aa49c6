// SPDX-License-Identifier: MIT
// The drift over packs: the same motion for every instruction set, whatever the other lanes of a
// pack.
#include "polhode/integrate/flows.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "instruction_sets.hpp"
#include "polhode/rotor/free_rotation.hpp"

using namespace polhode;

namespace {

constexpr std::size_t count = 103;  // fills no pack exactly

/// Bodies of all kinds in a pack: asymmetric, linear along each axis, at rest; most rotate by 0.05
/// to 0.3 in a step of 1, a few by 0.5, 5 and 50.
struct Crowd {
  Bodies bodies;
  State state{count, Box{}};

  Crowd()
      : bodies(Topology{{{rigid_molecule("n2", {{.name = "N1", .r = {0, 0, 0}, .mass = 14.0},
                                                {.name = "N2", .r = {0, 0.1, 0}, .mass = 14.0}}),
                          count}}}) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> uniform(0.1, 1);
    std::normal_distribution<double> normal;
    const auto vector = [&] {
      return Vec3<double>{normal(random), normal(random), normal(random)};
    };
    for (std::size_t n = 0; n < count; ++n) {
      const double a = uniform(random), b = uniform(random), c = uniform(random);
      Vec3<double> J{b + c, c + a, a + b}, w = vector();
      double angle = 0.3 * uniform(random);
      if (n % 20 == 3) angle = 0.5;
      if (n % 20 == 7) angle = 5;
      if (n % 40 == 11) angle = 50;
      if (n % 10 == 5) angle = 0;
      w *= angle / norm(w);
      if (n % 6 == 4) {
        const std::size_t rod = n / 6 % 3;
        J = {a, a, a};
        J[rod] = 0;
        w[rod] = 0;
      }
      bodies.J.set(n, J);
      const auto inverse = [](double moment) { return moment == 0 ? 0.0 : 1 / moment; };
      bodies.inverse_J.set(n, {inverse(J.x), inverse(J.y), inverse(J.z)});
      const Quaternion<double> q = normalized(
          Quaternion<double>{normal(random), normal(random), normal(random), normal(random)});
      state.orientation.set(n, q);
      state.ell.set(n, to_lab(q, scaled(J, w)));
      state.q.set(n, vector());
      state.p.set(n, vector());
    }
  }
};

double distance(const Quaternion<double>& a, const Quaternion<double>& b) {
  return norm((conjugate(a) * b).vector());
}

}  // namespace

// L = S ell has three roundings of size |L|, in the direction of a change that k_abs measures: k <=
// 6 (1 + |ω t|) for these shapes (the truth table's k_abs of asymmetric tops). Then 16 ε (1 + k).
TEST_CASE("drift rotates every body of a pack freely") {
  for_each_instruction_set([] {
    Crowd crowd;
    const Crowd before;
    drift(crowd.state, crowd.bodies, 1.0);
    for (std::size_t n = 0; n < count; ++n) {
      const Quaternion<double> q = before.state.orientation[n];
      const Vec3<double> L = to_body(q, before.state.ell[n]), J = before.bodies.J[n];
      Vec3<double> clean = L;  // a rod has no L along its axis
      for (std::size_t k = 0; k < 3; ++k)
        if (J[k] == 0) clean[k] = 0;
      const FreeRotation exact = closed_rotation(J, clean, 1.0);
      const double angle = norm(scaled(before.bodies.inverse_J[n], L));
      const double bound = 16 * 0x1p-53 * (1 + 6 * (1 + angle));
      CAPTURE(n);
      CHECK(distance(crowd.state.orientation[n], q * exact.rotation) <= bound);
      CHECK(std::abs(norm2(crowd.state.orientation[n]) - 1) <= 8 * 0x1p-53);
      CHECK(crowd.state.ell[n] == before.state.ell[n]);
      CHECK(norm(crowd.state.q[n] - before.state.q[n] -
                 before.state.p[n] * before.bodies.inverse_m[n]) <= 8 * 0x1p-53);
    }
  });
}

// Exactly on the separatrix, far beyond the series: orientations are the identity, so that L = S
// ell is exact. The other lanes rotate regularly.
TEST_CASE("drift handles bodies on the separatrix in packs with others") {
  for_each_instruction_set([] {
    for (const double t : {20.0, 250.0, 25000.0, -1e5}) {
      Crowd crowd;
      for (std::size_t n = 0; n < count; ++n) {
        if (n % 3 == 1) continue;
        const Vec3<double> J{12, 15, 20}, L{n % 2 == 0 ? 1.0 : -1.0, double(n % 5) - 2, 1};
        crowd.bodies.J.set(n, J);
        crowd.bodies.inverse_J.set(n, {1 / J.x, 1 / J.y, 1 / J.z});
        crowd.state.orientation.set(n, {1, 0, 0, 0});
        crowd.state.ell.set(n, L);
      }
      const Crowd before = crowd;
      drift(crowd.state, crowd.bodies, t);
      for (std::size_t n = 0; n < count; ++n) {
        if (n % 3 == 1) continue;
        const FreeRotation exact =
            closed_rotation(before.bodies.J[n], before.state.ell[n], t, ThirdKind::theta);
        // As for the truth table's rows there: three angles of |ω t| and a few roundings.
        const double bound = 16 * 0x1p-53 * (1 + 3 * std::abs(t) * 0.25);
        CAPTURE(n);
        CHECK(distance(crowd.state.orientation[n], exact.rotation) <= bound);
      }
    }
  });
}

// Instruction sets differ by contraction into fused operations only: half a rounding each, on both
// sides of the bound above, and none may differ by more than two of those.
TEST_CASE("drift agrees between instruction sets") {
  const InstructionSet before = current_instruction_set();
  force_instruction_set(InstructionSet::scalar);
  Crowd reference;
  for (int n = 0; n < 20; ++n) drift(reference.state, reference.bodies, 0.1);
  force_instruction_set(before);
  for_each_instruction_set([&] {
    Crowd crowd;
    for (int n = 0; n < 20; ++n) drift(crowd.state, crowd.bodies, 0.1);
    for (std::size_t n = 0; n < count; ++n) {
      const double angle =
          2 * norm(scaled(crowd.bodies.inverse_J[n],
                          to_body(reference.state.orientation[n], reference.state.ell[n])));
      CHECK(distance(crowd.state.orientation[n], reference.state.orientation[n]) <=
            20 * 16 * 0x1p-53 * (1 + 6 * angle));
    }
  });
}

// The remaining L along an axis without inertia is the rounding of a rotation to the lab frame: a
// few roundings of L, for any number of kicks. Without inertia at all L is 0. Along other axes a
// kick is ell + t tau, to the last bit.
TEST_CASE("kicks give no angular momentum about an axis without inertia") {
  for_each_instruction_set([] {
    Crowd crowd;
    crowd.bodies.inverse_J.set(9, {});
    std::mt19937_64 random(8);
    std::normal_distribution<double> normal;
    Load load(count);
    Vec3Column ell = crowd.state.ell;
    for (int n = 0; n < 200; ++n) {
      for (std::size_t i = 0; i < count; ++i) {
        load.tau.set(i, {normal(random), normal(random), normal(random)});
        ell.add(i, 0.01 * load.tau[i]);
      }
      kick(crowd.state, crowd.bodies, load, 0.01);
    }
    int rods = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3<double> inverse_J = crowd.bodies.inverse_J[i];
      const Vec3<double> L = to_body(crowd.state.orientation[i], crowd.state.ell[i]);
      const Vec3<double> plain = to_body(crowd.state.orientation[i], ell[i]);
      CAPTURE(i);
      const bool whole = inverse_J.x > 0 && inverse_J.y > 0 && inverse_J.z > 0;
      if (whole) CHECK(norm(crowd.state.ell[i] - ell[i]) < 200 * 0x1p-52 * norm(ell[i]) + 1e-13);
      rods += !whole;
      for (std::size_t k = 0; k < 3; ++k) {
        if (inverse_J[k] == 0)
          CHECK(std::abs(L[k]) <= 8 * 0x1p-53 * norm(crowd.state.ell[i]));
        else  // 200 roundings of two rotations each
          CHECK(std::abs(L[k] - plain[k]) <= 200 * 16 * 0x1p-53 * (norm(plain) + 1));
      }
    }
    CHECK(rods > 10);
    CHECK(norm(crowd.state.ell[9]) == 0);
  });
}

// The flow is its own inverse under t -> -t; two steps at the bound of the first test.
TEST_CASE("drift forward and back is the identity") {
  for_each_instruction_set([] {
    Crowd crowd;
    const Crowd before;
    drift(crowd.state, crowd.bodies, 0.7);
    drift(crowd.state, crowd.bodies, -0.7);
    for (std::size_t n = 0; n < count; ++n) {
      const double angle =
          0.7 * norm(scaled(before.bodies.inverse_J[n],
                            to_body(before.state.orientation[n], before.state.ell[n])));
      CHECK(distance(crowd.state.orientation[n], before.state.orientation[n]) <=
            2 * 16 * 0x1p-53 * (1 + 6 * (1 + angle)));
    }
  });
}

// A diverged run must end with an error, not in an infinite loop.
TEST_CASE("drift returns for infinite and undefined angular momenta") {
  for (const double bad :
       {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN(), 1e300}) {
    Crowd crowd;
    crowd.state.ell.set(2, {bad, 0.1, 0.2});
    drift(crowd.state, crowd.bodies, 1.0);
    CHECK(std::isfinite(crowd.state.orientation[40].w));
  }
}
