// SPDX-License-Identifier: MIT
// The finite-size correction of diffusion in rectangular boxes, against published constants.
#include "measure/finite_size.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "polhode/base/units.hpp"

using namespace polhode;

namespace {

constexpr double ratio = 2.7933596497;  // of OrthoBoXY [busch2023]

}  // namespace

// The constant of a cubic lattice is 2.837297479 [kikugawa2015], of which yeh2004 gives seven
// digits.
TEST_CASE("the correction of a cubic box is that of Yeh and Hummer") {
  for (const double L : {0.7, 1.0, 30.0}) {
    const Vec3<double> m = image_mobility({L, L, L});
    for (std::size_t axis = 0; axis < 3; ++axis)
      CHECK(std::abs(m[axis] * 6 * std::numbers::pi * L - 2.837297479) < 1e-9);
    const Vec3<double> D = finite_size_correction(300, 500, {L, L, L});
    const double published = 2.837297 * units::boltzmann * 300 / (6 * units::pi * 500 * L);
    CHECK(std::abs(D.x / published - 1) < 2e-7);
  }
}

// The derivative of the sum x + y by the ratio is of order 1/L: ten digits of the ratio make it
// vanish to 1e-10, and the published coefficient has eleven digits.
TEST_CASE("a box of the OrthoBoXY ratio has no correction along its short axes") {
  for (const double L : {0.5, 1.0, 4.0}) {
    const Vec3<double> m = image_mobility({L, L, ratio * L});
    CHECK(std::abs(m.x * L) < 1e-10);
    CHECK(std::abs(m.y * L) < 1e-10);
    // D_x + D_y − 2 D_z of such a box is kT/eta times 2 m_z − m_x − m_y.
    CHECK(std::abs((2 * m.z - m.x - m.y) * 3 * std::numbers::pi * ratio * L - 8.1711245653) <
          2e-10);
    CHECK(image_mobility({L, L, 1.001 * ratio * L}).x * L < -1e-5);
    CHECK(image_mobility({L, L, 0.999 * ratio * L}).x * L > 1e-5);
  }
}

// The sum over the reciprocal lattice with a Gaussian of width w converges, and so does the
// integral over all wave vectors: their difference is the correction plus terms of w², which cancel
// between two widths, and of w⁴, 1e-5 of the correction. Images are 10 widths away.
TEST_CASE("the correction is an integral over wave vectors minus the sum over the lattice") {
  const Vec3<double> edge{1, 1.4, 2.3};
  const auto difference = [&](double width) {
    // Of the tensor, 2/3 is left by the mean over directions.
    const double integral = 2.0 / 3 / (4 * std::pow(std::numbers::pi, 1.5) * width);
    Vec3<double> rest{integral, integral, integral};
    const int last = 60;  // the largest wave vector along z has k w = 8: exp(−67)
    for (int x = -last; x <= last; ++x)
      for (int y = -last; y <= last; ++y)
        for (int z = -last; z <= last; ++z) {
          const Vec3<double> k{2 * std::numbers::pi * x / edge.x, 2 * std::numbers::pi * y / edge.y,
                               2 * std::numbers::pi * z / edge.z};
          const double k2 = norm2(k);
          if (k2 == 0) continue;
          const double share = std::exp(-k2 * width * width) / (k2 * edge.x * edge.y * edge.z);
          for (std::size_t a = 0; a < 3; ++a) rest[a] -= share * (1 - k[a] * k[a] / k2);
        }
    return rest;
  };
  const Vec3<double> expected = (4 * difference(0.05) - difference(0.1)) / 3.0;
  const Vec3<double> m = image_mobility(edge);
  for (std::size_t a = 0; a < 3; ++a) CHECK(m[a] == doctest::Approx(expected[a]).epsilon(2e-5));
  const Vec3<double> turned = image_mobility({edge.y, edge.z, edge.x});
  CHECK(turned.x == doctest::Approx(m.y).epsilon(1e-12));
  CHECK(turned.z == doctest::Approx(m.x).epsilon(1e-12));
}
