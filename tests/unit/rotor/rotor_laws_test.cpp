// SPDX-License-Identifier: MIT
// Laws of the free rotation, for all methods.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

#include "polhode/rotor/free_rotation.hpp"

using namespace polhode;

namespace {

constexpr double epsilon = 0x1p-53;  // one rounding
constexpr std::array exact_methods{RotorMethod::series, RotorMethod::closed, RotorMethod::theta,
                                   RotorMethod::recursive};

struct RandomTop {
  Vec3<double> J, L;
};

/// A body of random masses on three axes, in a random order of axes; L of length one.
RandomTop random_top(std::mt19937_64& random) {
  std::uniform_real_distribution<double> mass(0.1, 1);
  std::normal_distribution<double> normal;
  const double a = mass(random), b = mass(random), c = mass(random);
  const Vec3<double> l{normal(random), normal(random), normal(random)};
  return {{b + c, c + a, a + b}, l / norm(l)};
}

double distance(const Quaternion<double>& a, const Quaternion<double>& b) {
  const Mat3<double> A = matrix_S(a), B = matrix_S(b);
  double largest = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) largest = std::fmax(largest, std::abs(A[i][j] - B[i][j]));
  return largest;
}

/// Change of the rotation, in units of ε, when each input has a relative change of ε: finite
/// differences of the closed form, whose error, 1e-6 of k, is negligible.
double conditioning(const Vec3<double>& J, const Vec3<double>& L, double t) {
  const double step = 1e-6;
  const Quaternion<double> r = closed_rotation(J, L, t).rotation;
  double k = distance(closed_rotation(J, L, t * (1 + step)).rotation, r);
  for (std::size_t i = 0; i < 3; ++i) {
    Vec3<double> changed_J = J, changed_L = L;
    changed_J[i] *= 1 + step;
    changed_L[i] *= 1 + step;
    k += distance(closed_rotation(changed_J, L, t).rotation, r);
    k += distance(closed_rotation(J, changed_L, t).rotation, r);
  }
  return k / step;
}

double energy(const Vec3<double>& J, const Vec3<double>& L) {
  return 0.5 * (L.x * L.x / J.x + L.y * L.y / J.y + L.z * L.z / J.z);
}

}  // namespace

// Three rotations have errors of at most 16 ε (1 + k) each; the k of the second one with respect to
// L(s), which has the error of the first, multiplies: k(t) k(s), bounded through k(s + t) + k(s)
// k(t).
TEST_CASE("free rotations form a group in time") {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> time(-3, 3);
  for (const RotorMethod method : exact_methods) {
    for (int n = 0; n < 300; ++n) {
      const auto [J, L] = random_top(random);
      const double s = time(random), t = time(random);
      const FreeRotation first = free_rotation(J, L, s, method);
      const FreeRotation second = free_rotation(J, first.L, t, method);
      const FreeRotation both = free_rotation(J, L, s + t, method);
      const double k = (1 + conditioning(J, L, s)) * (1 + conditioning(J, first.L, t)) +
                       conditioning(J, L, s + t);
      CHECK(distance(first.rotation * second.rotation, both.rotation) <= 3 * 16 * epsilon * k);
    }
  }
}

TEST_CASE("a second-order splitting is not a group in time") {
  const Vec3<double> J{1, 2, 3}, L{0.4, 0.5, 0.6};
  const FreeRotation first = no_squish_rotation(J, L, 0.5);
  const FreeRotation second = no_squish_rotation(J, first.L, 0.5);
  const FreeRotation both = no_squish_rotation(J, L, 1.0);
  CHECK(distance(first.rotation * second.rotation, both.rotation) > 1e-4);
}

// |L| is restored by one division, 4 roundings with those of the norm. E changes by the direction's
// error, 16 ε (1 + k) at most, times the spread of 1/J, below 1/J_min; 2E >= |L|²/J_max.
TEST_CASE("energy and angular momentum are conserved along an orbit") {
  std::mt19937_64 random(2);
  for (const RotorMethod method : exact_methods) {
    for (int n = 0; n < 300; ++n) {
      const auto [J, L] = random_top(random);
      for (const double t : {-0.1, 0.25, 2.0, 17.0}) {
        const FreeRotation later = free_rotation(J, L, t, method);
        CHECK(std::abs(norm(later.L) / norm(L) - 1) <= 8 * epsilon);
        CHECK(std::abs(norm2(later.rotation) - 1) <= 8 * epsilon);
        const double spread =
            std::max({J.x, J.y, J.z}) / std::min({J.x, J.y, J.z}) * (1 + conditioning(J, L, t));
        CHECK(std::abs(energy(J, later.L) / energy(J, L) - 1) <= 16 * epsilon * spread);
        // P(t) L(0) = L(t): both come from different formulas
        const Vec3<double> turned = to_body(later.rotation, L);
        CHECK(norm(turned - later.L) <= 32 * epsilon * (1 + conditioning(J, L, t)));
      }
    }
  }
}

TEST_CASE("special cases of the free rotation agree with their closed forms") {
  const Vec3<double> L{0.3, -0.4, 1.2};
  for (const RotorMethod method : exact_methods) {
    for (const double t : {0.1, 3.0, -40.0}) {
      // 8 roundings of an angle below 100 and of its sine, according to the condition number |ω t|
      const double bound = 8 * epsilon * (1 + 1.3 / 0.5 * std::abs(t));
      const Quaternion<double> sphere = free_rotation({0.5, 0.5, 0.5}, L, t, method).rotation;
      CHECK(distance(sphere, rotation_quaternion(L * (t / 0.5))) <= bound);
      // symmetric: L precesses about z at L_z (1/J_z - 1/J_x), the orientation also rotates about L
      const double rate = L.z * (1 / 0.8 - 1 / 0.5);
      const Quaternion<double> symmetric = free_rotation({0.5, 0.5, 0.8}, L, t, method).rotation;
      const Quaternion<double> product =
          rotation_quaternion(L * (t / 0.5)) * rotation_quaternion({0, 0, rate * t});
      CHECK(distance(symmetric, product) <= 2 * bound);
      // linear, any axis
      const FreeRotation rod = free_rotation({0.5, 0, 0.5}, {L.x, 0, L.z}, t, method);
      CHECK(distance(rod.rotation, rotation_quaternion(Vec3<double>{L.x, 0, L.z} * (t / 0.5))) <=
            bound);
    }
    CHECK(free_rotation({1, 2, 3}, {0, 0, 0}, 5, method).rotation == Quaternion<double>{});
    CHECK(distance(free_rotation({1, 2, 3}, L, 0, method).rotation, {}) <= 4 * epsilon);
  }
}

// Powers of two scale without rounding, so no bit may change; any absolute threshold would be
// detected. (Powers of ten are in the truth tables.)
TEST_CASE("free rotations do not depend on units") {
  std::mt19937_64 random(3);
  for (const RotorMethod method : exact_methods) {
    for (int n = 0; n < 50; ++n) {
      const auto [J, L] = random_top(random);
      for (const double t : {0.2, 7.0}) {
        const FreeRotation here = free_rotation(J, L, t, method);
        for (const int power : {-330, -50, 50, 330}) {
          const FreeRotation there =
              free_rotation(J * std::ldexp(1.0, power), L * std::ldexp(1.0, -power / 2),
                            std::ldexp(t, power + power / 2), method);
          CHECK(there.rotation == here.rotation);
          CHECK(there.L == here.L * std::ldexp(1.0, -power / 2));
        }
      }
    }
  }
}

// A step's rotation and the product each round four numbers: about 2 ε of angle, without bias if
// the method has none. After N steps that is a random walk of 2 ε √N; six standard deviations bound
// it. A bias of one rounding per step would appear as N ε, a hundred times more. E follows the
// angle by |dE| <= |L|² (1/J_min - 1/J_max) angle; |q| is restored in every step.
TEST_CASE("norm and energy do not grow linearly over a million steps") {
  const int steps = 1000000;
  const Vec3<double> ell{0.3, 0.5, -0.4};
  // water, and a top that nearly repeats the same rotation, and the same rounding, in every step
  for (const Vec3<double>& J : {Vec3<double>{0.61457, 1.15512, 1.76968}, {0.9, 0.9001, 0.9002}}) {
    const Vec3<double> inverse_J{1 / J.x, 1 / J.y, 1 / J.z};
    Quaternion<double> orientation;
    Vec3<double> free_L = ell;  // in the body frame, where its length is not restored
    const double E = energy(J, ell);
    double worst_q = 0;
    for (int n = 0; n < steps; ++n) {
      const Quaternion<double> r =
          unnormalized_rotation<long_series>(inverse_J, to_body(orientation, ell), 0.3);
      orientation = normalized(orientation * r);
      worst_q = std::fmax(worst_q, std::abs(norm2(orientation) - 1));
      free_L =
          to_body(normalized(unnormalized_rotation<long_series>(inverse_J, free_L, 0.3)), free_L);
    }
    const double walk = 6 * 2 * epsilon * std::sqrt(steps);
    const double lever = norm2(ell) * (1 / J.x - 1 / J.z) / E;
    CHECK(worst_q <= 8 * epsilon);
    // and twice the rounding of |q|², which affects E
    CHECK(std::abs(energy(J, to_body(orientation, ell)) / E - 1) <= lever * walk + 16 * epsilon);
    CHECK(std::abs(norm(free_L) / norm(ell) - 1) <= walk);
    CHECK(std::abs(energy(J, free_L) / E - 1) <= (lever + 2) * walk);
  }
}

// The same flow in two representations: each rounds about 40 operations of size 1.
TEST_CASE("NO_SQUISH is the symmetric product of principal-axis rotations") {
  std::mt19937_64 random(4);
  for (int n = 0; n < 100; ++n) {
    const auto [J, L] = random_top(random);
    const FreeRotation a = no_squish_rotation(J, L, 0.7), b = symmetric_product_rotation(J, L, 0.7);
    CHECK(distance(a.rotation, b.rotation) <= 40 * epsilon);
    CHECK(norm(a.L - b.L) <= 40 * epsilon);
  }
}

// A symmetric method of second order has an error of C h³ + O(h⁵) in one step: halving h divides by
// 8, and the next term is (ω h)² ≈ 0.002 of it.
TEST_CASE("the error of NO_SQUISH is of third order per step") {
  const Vec3<double> J{0.7, 1.1, 1.5}, L{0.5, 0.6, -0.4};
  const auto error = [&](double h) {
    return distance(no_squish_rotation(J, L, h).rotation, closed_rotation(J, L, h).rotation);
  };
  CHECK(std::log2(error(0.04) / error(0.02)) == doctest::Approx(3).epsilon(0.02));
}
