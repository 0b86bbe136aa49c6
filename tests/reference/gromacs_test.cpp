// SPDX-License-Identifier: MIT
// The same system in GROMACS and polhode: same files, same energies
// (tests/reference/gromacs/README.md).
#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

#include "polhode/io/topology/gromacs.hpp"
#include "polhode/run/simulation/system/system.hpp"
#include "skip.hpp"

using namespace polhode;

namespace {

const std::string gromacs_data = POLHODE_TEST_DATA "/gromacs/";

struct GromacsEnergies {
  double van_der_waals = 0, coulomb = 0;  // [kJ/mol]
};

GromacsEnergies gromacs_energies() {
  std::ifstream in(gromacs_data + "energies.txt");
  std::string head;
  std::getline(in, head);
  double time = 0, real_space = 0, mesh = 0;
  GromacsEnergies e;
  in >> time >> e.van_der_waals >> real_space >> mesh;
  REQUIRE(bool(in));
  e.coulomb = real_space + mesh;
  return e;
}

}  // namespace

TEST_CASE("salt water made with GROMACS tools has the energies of GROMACS") {
  if (!gromacs_data_folder())
    return skip("GROMACS data is not installed; on Debian: apt-get install gromacs-data");
  const System system = build_system(parse_config(
      "[system]\ntopology = \"topol.top\"\ninitial_configuration = "
      "\"conf.gro\"\n[forces]\nelectrostatics = \"pme\"\n"
      "pme_accuracy = 1e-6\ncutoff = \"0.9 nm\"\nswitch = \"0.75 nm\"\nsmoothness = 2\n",
      gromacs_data + "system.toml"));
  REQUIRE(system.topology.parts.size() == 3);
  CHECK(system.topology.parts[0].count == 215);
  CHECK(system.origins[0] == "rigid by settles");
  // SETTLE constrains distances to single precision, 1e-7 nm, and the file rounds to that.
  CHECK(system.fit_deviation < 1e-6);
  ForceField forces(system.topology, system.forces, system.state.box);
  Load load;
  forces(system.state, load);
  const GromacsEnergies gromacs = gromacs_energies();
  // GROMACS sums about 1e5 pairs of up to 1e2 kJ/mol in single precision, whose rounding is 6e-8,
  // and its PME truncates real space at 1e-6; the coordinates have errors of 1e-7 nm in 0.1 nm. The
  // self-energy and intramolecular corrections are 1e5 kJ/mol each, seven times the difference.
  CAPTURE(load.van_der_waals);
  CAPTURE(load.coulomb);
  CHECK(std::abs(load.van_der_waals / gromacs.van_der_waals - 1) < 1e-5);
  CHECK(std::abs(load.coulomb / gromacs.coulomb - 1) < 1e-5);
}
