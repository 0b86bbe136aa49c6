// SPDX-License-Identifier: MIT
#include "polhode/model/molecule.hpp"

#include <doctest/doctest.h>

#include "polhode/base/error.hpp"

using namespace polhode;

TEST_CASE("a diatomic is a linear top with moment mu r^2") {
  const Molecule n2 = rigid_molecule("n2", {{.name = "N1", .r = {0.3, 0.1, 0.2}, .mass = 14.0},
                                            {.name = "N2", .r = {0.3, 0.2, 0.2}, .mass = 14.0}});
  CHECK(n2.top == Top::linear);
  CHECK(n2.J.x == 0.0);
  CHECK(n2.J.y == doctest::Approx(7.0 * 0.01).epsilon(1e-14));
}
