// SPDX-License-Identifier: MIT
#include "polhode/model/molecule.hpp"

#include <doctest/doctest.h>

#include "model/molecule_in_frame.hpp"
#include "polhode/base/error.hpp"
#include "polhode/io/topology/molecule_file.hpp"
#include "polhode/math/rotation.hpp"

using namespace polhode;

TEST_CASE("a diatomic is a linear top with moment mu r^2") {
  const Molecule n2 = rigid_molecule("n2", {{.name = "N1", .r = {0.3, 0.1, 0.2}, .mass = 14.0},
                                            {.name = "N2", .r = {0.3, 0.2, 0.2}, .mass = 14.0}});
  CHECK(n2.top == Top::linear);
  CHECK(n2.J.x == 0.0);
  CHECK(n2.J.y == doctest::Approx(7.0 * 0.01).epsilon(1e-14));
}

TEST_CASE("a molecule made of its own sites in their frame has the same axes") {
  const Quaternion<double> turn = rotation_quaternion(Vec3<double>{0.3, -1.1, 0.7});
  for (const std::string& name : molecule_names()) {
    CAPTURE(name);
    for (const bool turned : {false, true}) {
      Molecule molecule = read_molecule(name);
      if (turned) {
        for (Site& site : molecule.sites) site.r = to_lab(turn, site.r);
        molecule = rigid_molecule(name, molecule.sites);
      }
      const Molecule again = molecule_in_frame(name, molecule.sites);
      CHECK(again.top == molecule.top);
      // Sites of 1 nm at most have rounding of 2⁻⁵³ nm, and a centre of as much.
      for (std::size_t k = 0; k < again.sites.size(); ++k)
        CHECK(norm(again.sites[k].r - molecule.sites[k].r) < 1e-15);
    }
  }
}
