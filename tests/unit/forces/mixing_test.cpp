// SPDX-License-Identifier: MIT
#include "polhode/forces/laws/mixing.hpp"

#include <cmath>

#include "../errors.hpp"
#include "polhode/forces/force_field.hpp"
#include "reference_forces.hpp"

using namespace polhode;

namespace {

Molecule atom(const std::string& name, double sigma, double epsilon) {
  return rigid_molecule(name, {{.name = "X", .mass = 20, .sigma = sigma, .epsilon = epsilon}});
}

// Two sites of one name and one of another, at 0, 0.1 and 0.2 nm along x from the first, which is
// 0.1 nm left of the centre of mass.
Molecule rod() {
  return rigid_molecule(
      "rod", {{.name = "A", .mass = 10, .sigma = 0.2, .epsilon = 0.3},
              {.name = "A", .r = {0.1, 0, 0}, .mass = 10, .sigma = 0.2, .epsilon = 0.3},
              {.name = "B", .r = {0.2, 0, 0}, .mass = 10, .sigma = 0.25, .epsilon = 0.4}});
}

double lennard_jones(double sigma, double epsilon, double r) {
  const double x = std::pow(sigma / r, 6);
  return 4 * epsilon * (x * x - x);
}

// The energy of one body of each of two molecules, r apart along x, far below the switch.
double energy(const Molecule& a, const Molecule& b, double r, const Mixing& mixing,
              Precision precision = Precision::double_precision) {
  const Topology topology{{{a, 1}, {b, 1}}};
  State state(2, Box{{10, 10, 10}});
  state.q.set(0, {1, 1, 1});
  state.q.set(1, {1 + r, 1, 1});
  ForceSettings settings{.cutoff = 2, .switch_from = 1.8, .precision = precision};
  settings.mixing = mixing;
  ForceField forces(topology, settings, state.box);
  Load load;
  forces(state, load);
  std::vector<Pose<double>> poses;
  for (std::size_t i = 0; i < 2; ++i) poses.push_back({state.q[i], state.orientation[i]});
  const double plain = reference_load(topology, settings, state.box, poses).van_der_waals;
  // Float: three roundings of 2⁻²⁴ in r², which count six times in r¹², and of the strengths.
  CHECK(load.van_der_waals ==
        doctest::Approx(plain).epsilon(precision == Precision::double_precision ? 1e-13 : 1e-5));
  return plain;
}

const Molecule a = atom("a", 0.3, 0.5), b = atom("b", 0.4, 0.8);

}  // namespace

TEST_CASE("unlike sites follow the mixing rule") {
  const double r = 0.45;
  const Mixing usual, geometric{.rule = MixingRule::geometric};
  CHECK(energy(a, b, r, usual) ==
        doctest::Approx(lennard_jones(0.35, std::sqrt(0.4), r)).epsilon(1e-13));
  CHECK(energy(a, b, r, geometric) ==
        doctest::Approx(lennard_jones(std::sqrt(0.12), std::sqrt(0.4), r)).epsilon(1e-13));
  energy(a, b, r, geometric, Precision::mixed);
  // For like sites the rules agree.
  CHECK(energy(a, a, r, usual) == doctest::Approx(energy(a, a, r, geometric)).epsilon(1e-13));
}

TEST_CASE("an explicit pair overrides the mixing rule, in either order") {
  const double r = 0.45, given = lennard_jones(0.33, 1.2, r);
  for (const Mixing& mixing : {Mixing{.pairs = {{"a.X", "b.X", 0.33, 1.2}}},
                               Mixing{.pairs = {{"b.X", "a.X", 0.33, 1.2}}}}) {
    CHECK(energy(a, b, r, mixing) == doctest::Approx(given).epsilon(1e-13));
    CHECK(energy(b, a, r, mixing) == doctest::Approx(given).epsilon(1e-13));
    energy(a, b, r, mixing, Precision::mixed);
  }
  // Also like sites, and no sites at all.
  CHECK(energy(a, a, r, {.pairs = {{"a.X", "a.X", 0.33, 1.2}}}) ==
        doctest::Approx(given).epsilon(1e-13));
  CHECK(energy(a, b, r, {.pairs = {{"a.X", "b.X", 0.33, 0}}}) == 0);
}

TEST_CASE("an explicit pair applies to all sites of these names and no others") {
  const double r =
      0.6;  // of the centres: sites of the rod are r + 0.1, r and r − 0.1 from the atom
  const double B = lennard_jones((0.25 + 0.3) / 2, std::sqrt(0.4 * 0.5), r - 0.1);
  CHECK(energy(rod(), a, r, {.pairs = {{"rod.A", "a.X", 0.28, 0.9}}}) ==
        doctest::Approx(lennard_jones(0.28, 0.9, r + 0.1) + lennard_jones(0.28, 0.9, r) + B)
            .epsilon(1e-13));
  const double A = lennard_jones(0.25, std::sqrt(0.3 * 0.5), r + 0.1) +
                   lennard_jones(0.25, std::sqrt(0.3 * 0.5), r);
  CHECK(energy(rod(), a, r, {.pairs = {{"rod.B", "a.X", 0.28, 0.9}}}) ==
        doctest::Approx(A + lennard_jones(0.28, 0.9, r - 0.1)).epsilon(1e-13));
}

TEST_CASE("impossible pairs are refused") {
  Molecule water =
      rigid_molecule("water", {{.name = "O", .mass = 16, .sigma = 0.3, .epsilon = 0.6},
                               {.name = "H", .r = {0.1, 0, 0}, .mass = 1, .charge = 0.4}});
  const Topology topology{{{water, 1}, {a, 1}}};
  const auto refuse = [&](std::vector<PairOverride> pairs,
                          std::initializer_list<const char*> parts) {
    check_error([&] { check({.pairs = pairs}, topology); }, parts);
    ForceSettings settings{.cutoff = 1, .switch_from = 0.9};
    settings.mixing.pairs = pairs;
    check_error([&] { ForceField(topology, settings, Box{{3, 3, 3}}); }, parts);
  };
  refuse({{"watr.O", "a.X", 0.3, 1}}, {"no site 'watr.O' in this system; did you mean 'water.O'?"});
  refuse({{"a.X", "O", 0.3, 1}},
         {"no site 'O' in this system", "written as molecule.site", "water.O, a.X"});
  refuse({{"water.H", "a.X", 0.3, 1}}, {"'water.H' has no short-range potential", "molecule file"});
  refuse({{"water.O", "a.X", 0.3, -1}}, {"'water.O' and 'a.X'", "epsilon -1 kJ/mol", "0 or more"});
  refuse({{"water.O", "a.X", NAN, 1}}, {"sigma is nan nm", "finite"});
  refuse({{"water.O", "a.X", 0, 1}}, {"sigma is 0", "needs both"});
  refuse({{"water.O", "a.X", 0.3, 1}, {"a.X", "water.O", 0.3, 2}}, {"is given twice; delete one"});
  check_error(
      [&] {
        check({.pairs = {{"w.H", "w.H", 0.3, 1}}},
              {{{rigid_molecule("w", {{.name = "H", .mass = 1}}), 1}}});
      },
      {"'w.H' has no short-range potential"});
  check({.pairs = {{"water.O", "a.X", 0.3, 1}, {"a.X", "a.X", 0.3, 0}}}, topology);
}

TEST_CASE("mixing is described if it is not the default") {
  CHECK(description({}).empty());
  CHECK(description({.rule = MixingRule::geometric}) == "geometric mixing");
  CHECK(description({MixingRule::geometric, {{"a.X", "b.X", 0.33, 1.2}}}) ==
        "geometric mixing; a.X with b.X: sigma 0.33 nm, epsilon 1.2 kJ/mol");
  CHECK(
      description({.pairs = {{"a.X", "b.X", 0.1, 0}, {"b.X", "b.X", 0.1, 1}}}) ==
      "a.X with b.X: sigma 0.1 nm, epsilon 0 kJ/mol; b.X with b.X: sigma 0.1 nm, epsilon 1 kJ/mol");
}
