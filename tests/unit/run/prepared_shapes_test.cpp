// SPDX-License-Identifier: MIT
// Molecules of GROMACS whose shape is a mean over the initial configuration: the run that starts
// from a preparation has the shape and the axes of the preparation, although its configuration has
// other orientations.
#include <doctest/doctest.h>
#include <fmt/core.h>

#include <cmath>
#include <fstream>
#include <random>
#include <string>

#include "../folder.hpp"
#include "base/version.hpp"
#include "polhode/base/quaternion.hpp"
#include "polhode/base/units.hpp"
#include "polhode/math/shape.hpp"
#include "polhode/run/prepare/preparation.hpp"
#include "polhode/run/simulation/simulation.hpp"
#include "run/simulation/files/checkpoint.hpp"

using namespace polhode;

namespace {

/// Atoms bonded to the one before, which leaves the shape to the initial configuration.
struct Flexible {
  Shape shape;
  std::string elements;
};

/// Benzene of OPLS: its ring is held flat by dihedrals only.
Flexible flexible_benzene() {
  Flexible molecule;
  for (const auto& [radius, element] : {std::pair{0.14, 'C'}, {0.248, 'H'}})
    for (int k = 0; k < 6; ++k) {
      const double angle = k * units::pi / 3;
      molecule.shape.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
      molecule.elements += element;
    }
  return molecule;
}

Flexible asymmetric() {
  return {{{0, 0, 0}, {0.143, 0, 0}, {0.19, 0.12, 0}, {-0.06, -0.02, 0.09}, {0.1, 0.2, 0.11}},
          "CONHH"};
}

std::string topology_of(const Flexible& molecule, std::size_t count) {
  std::string text =
      "[ defaults ]\n1 3\n[ atomtypes ]\nC 6 12.011 0 A 0.355 0.29288\nH 1 1.008 0 A 0.242 "
      "0.12552\nO 8 15.999 0 A 0.296 0.87864\nN 7 14.007 0 A 0.325 0.71128\n[ moleculetype ]\n"
      "MOL 3\n[ atoms ]\n";
  const std::size_t atoms = molecule.shape.size();
  for (std::size_t k = 0; k < atoms; ++k)
    text += fmt::format("{0} {1} 1 MOL {1}{0} 1 0\n", k + 1, molecule.elements[k]);
  text += "[ bonds ]\n";
  for (std::size_t k = 1; k < atoms; ++k) text += fmt::format("{} {} 1 0.14 1000\n", k, k + 1);
  return text + fmt::format("[ system ]\nliquid\n[ molecules ]\nMOL {}\n", count);
}

/// Molecules on a cubic lattice in random orientations, as a flexible model leaves them: each atom
/// is off its place by about 0.004 nm.
std::string configuration_of(const Flexible& molecule, int edge, double spacing,
                             std::mt19937& random) {
  std::normal_distribution<double> normal(0, 1);
  const int count = edge * edge * edge, atoms = static_cast<int>(molecule.shape.size());
  std::string text = fmt::format("liquid\n{}\n", count * atoms);
  for (int i = 0; i < count; ++i) {
    const auto turn = normalized(
        Quaternion<double>{normal(random), normal(random), normal(random), normal(random)});
    const Vec3<double> centre =
        spacing * Vec3<double>{i % edge + 0.5, i / edge % edge + 0.5, i / edge / edge + 0.5};
    for (int k = 0; k < atoms; ++k) {
      const auto at = static_cast<std::size_t>(k);
      const Vec3<double> off{normal(random), normal(random), normal(random)};
      const Vec3<double> r = centre + to_lab(turn, molecule.shape[at]) + 0.0025 * off;
      text += fmt::format("{:>5}MOL  {:>5}{:>5}{:>8.3f}{:>8.3f}{:>8.3f}\n", i + 1,
                          fmt::format("{}{}", molecule.elements[at], k + 1), i * atoms + k + 1, r.x,
                          r.y, r.z);
    }
  }
  return text + fmt::format("{0:.5f} {0:.5f} {0:.5f}\n", edge * spacing);
}

constexpr const char* run_file = R"([system]
topology = "topol.top"
initial_configuration = "conf.gro"
rigid = ["MOL"]
temperature = "300 K"
[forces]
cutoff = "0.6 nm"
[prepare]
nvt = "1 ps"
npt = "0 ps"
)";

Config prepared_config(const Folder& folder, const Flexible& molecule, unsigned seed) {
  std::mt19937 random(seed);
  std::ofstream(folder / "topol.top") << topology_of(molecule, 8);
  std::ofstream(folder / "conf.gro") << configuration_of(molecule, 2, 0.7, random);
  Config config = parse_config(run_file, folder / "run.toml");
  config.output.prefix = folder / "out";
  return config;
}

}  // namespace

TEST_CASE("a run has the shape and the axes of its preparation") {
  for (const Flexible& molecule : {flexible_benzene(), asymmetric()})
    for (unsigned seed = 1; seed <= 8; ++seed) {
      CAPTURE(molecule.elements);
      CAPTURE(seed);
      const Folder folder;
      const Config config = prepared_config(folder, molecule, seed);
      prepare(config);
      const System before = build_system(config);
      const System after = build_system(read_config(folder / "out-prepared.toml"));
      const auto& sites = before.topology.parts[0].molecule.sites;
      for (std::size_t k = 0; k < sites.size(); ++k)  // of 0.3 nm at most, as rounded
        CHECK(norm(after.topology.parts[0].molecule.sites[k].r - sites[k].r) < 1e-15);
      const State prepared = state_of_checkpoint(folder / "out-prepared.bin", version());
      CHECK(after.state.q[3] == prepared.q[3]);
      CHECK(after.state.orientation.w[3] == prepared.orientation.w[3]);

      // Derived again from the coordinates, as by a run file written by hand, the shape has their
      // rounding, but the same axes, so that the checkpoint fits.
      Config again = read_config(folder / "out-prepared.toml");
      again.system.topology.shapes.clear();
      CHECK(build_system(again).state.q[3] == prepared.q[3]);
    }
}
