// SPDX-License-Identifier: MIT
// The force evaluation in packs compared with a plain sum over all pairs: for every law, shape of
// molecules, instruction set and precision.
#include <doctest/doctest.h>

#include <array>

#include "instruction_sets.hpp"
#include "physics/force_laws.hpp"
#include "polhode/base/units.hpp"

using namespace polhode;

namespace {

double rms_distance(const std::vector<Vec3<double>>& a, const std::vector<Vec3<double>>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += norm2(a[i] - b[i]);
  return std::sqrt(sum / double(a.size()));
}

// The exact result of one law for one state, and its rounding errors.
struct Exact {
  ReferenceLoad<double> load;
  Terms terms;
  double scale;                   // the largest force
  double f_rounded, tau_rounded;  // rms errors of forces and torques in float

  // Mixed precision rounds a position in the box to 2⁻³⁰ of an edge; the difference of two of them,
  // its product with an edge and two sums with sites to float, by up to half of 2⁻²⁴ nm below 1 nm.
  // A uniformly distributed error has an rms of its width divided by √12; four roundings of a pair
  // are two for each of its bodies. The effect on forces is found by random displacements of that
  // size.
  Exact(const scenes::Scene& scene, const ForceSettings& settings)
      : load(reference_load(scene.topology, settings, scene.state.box, scenes::poses(scene.state))),
        terms(terms_of(scene, settings)) {
    scale = 0;
    for (const Vec3<double>& f : load.f) scale = std::max(scale, norm(f));
    constexpr int samples = 8;
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    double f2 = terms.f2, tau2 = terms.tau2;
    for (int k = 0; k < samples; ++k) {
      std::vector<Pose<double>> moved = scenes::poses(scene.state);
      for (Pose<double>& pose : moved)
        for (std::size_t d = 0; d < 3; ++d) {
          const double fixed = scene.state.box.edge[d] * 0x1p-30, rounded = 0x1p-24;
          pose.q[d] += std::sqrt((fixed * fixed + 2 * rounded * rounded) / 12) * normal(random);
        }
      const auto there = reference_load(scene.topology, settings, scene.state.box, moved);
      const double f = rms_distance(there.f, load.f), tau = rms_distance(there.tau, load.tau);
      f2 += f * f / samples, tau2 += tau * tau / samples;
    }
    f_rounded = std::sqrt(f2), tau_rounded = std::sqrt(tau2);
  }
};

// Double precision: R has a few roundings of a coordinate, 2⁻⁵³ of the edge each; the force of a
// contact of 0.25 nm changes by 13/0.25 nm relatively, and sums add a few roundings.
void check_double(const scenes::Scene& scene, const ForceSettings& settings, const Exact& exact) {
  const Box& box = scene.state.box;
  const double edge = std::max({box.edge.x, box.edge.y, box.edge.z});
  const double bound = 0x1p-53 * (500 + 8 * edge * 13 / 0.25) * exact.scale;
  ForceField forces(scene.topology, settings, scene.state.box);
  Load load;
  forces(scene.state, load);
  Load alone = load;  // with energies that must go
  CHECK(largest_difference(load.f, exact.load.f) < bound);
  CHECK(largest_difference(load.tau, exact.load.tau) < bound);
  CHECK(std::abs(load.van_der_waals - exact.load.van_der_waals) < bound);
  const double pairs = load.coulomb - forces.constant_terms().coulomb();
  CHECK(std::abs(pairs - exact.load.coulomb) < bound);
  CHECK(largest_difference(load.virial, exact.load.virial) < bound);
  // Without energies the compiler may fuse other products: rounding, not bits.
  forces.forces_alone(scene.state, alone);
  CHECK(largest_difference(alone.f, exact.load.f) < bound);
  CHECK(largest_difference(alone.tau, exact.load.tau) < bound);
  CHECK(alone.potential() == 0);
  CHECK(largest(alone.virial) == 0);
}

// Mixed precision: the rms error is that of rounded places and terms, within a factor of 3, as one
// contact may outweigh the rest. A thirtieth of it could not come from pairs in float. Energies and
// the virial sum the errors of all terms, which may be equal for a pair of molecules: for less than
// 49 terms of a pair, 7 times the root of the sum of squares.
void check_mixed(const scenes::Scene& scene, ForceSettings settings, const Exact& exact) {
  settings.precision = Precision::mixed;
  ForceField forces(scene.topology, settings, scene.state.box);
  Load load;
  forces(scene.state, load);
  Load alone = load;
  forces.forces_alone(scene.state, alone);
  for (const Load* l : {&load, &alone}) {
    const double f = rms_distance(l->f, exact.load.f) / exact.f_rounded;
    CAPTURE(f);
    CHECK(f < 3);
    CHECK(f > 0.03);
    if (exact.tau_rounded > 0) {
      const double tau = rms_distance(l->tau, exact.load.tau) / exact.tau_rounded;
      CAPTURE(tau);
      CHECK(tau < 3);
      CHECK(tau > 0.03);
    }
  }
  const double bound = 7 * std::sqrt(exact.terms.u2);
  CHECK(std::abs(load.van_der_waals - exact.load.van_der_waals) < bound);
  const double pairs = load.coulomb - forces.constant_terms().coulomb();
  CHECK(std::abs(pairs - exact.load.coulomb) < bound);
  CHECK(largest_difference(load.virial, exact.load.virial) < 7 * std::sqrt(exact.terms.virial2));
  CHECK(alone.potential() == 0);
  CHECK(largest(alone.virial) == 0);
}

void check_all_targets(const scenes::Scene& scene, const ForceSettings& settings) {
  const Exact exact(scene, settings);
  CHECK(exact.scale > 5);
  CHECK(largest(exact.load.virial) > 1);
  for_each_instruction_set([&] {
    check_double(scene, settings, exact);
    check_mixed(scene, settings, exact);
  });
}

// The same bodies elsewhere in a larger box.
scenes::Scene moved(scenes::Scene scene, const Vec3<double>& box, const Vec3<double>& by) {
  scene.state.box = Box{box};
  for (std::size_t i = 0; i < scene.state.size(); ++i) scene.state.q.set(i, scene.state.q[i] + by);
  return scene;
}

const Molecule& ion() {
  static const Molecule ion = rigid_molecule(
      "ion", {{.name = "I", .mass = 23, .charge = 1, .sigma = 0.333, .epsilon = 0.0116}});
  return ion;
}

const Molecule& two_sites() {
  static const Molecule dimer = [] {
    const Site site{.name = "N", .mass = 14, .charge = 0.1, .sigma = 0.33, .epsilon = 0.3};
    Site left = site, right = site;
    left.r.x = -0.055, right.r.x = 0.055, right.charge = -0.1;
    return rigid_molecule("dimer", {left, right});
  }();
  return dimer;
}

}  // namespace

TEST_CASE("pair loops equal the reference, for every instruction set, law, body and precision") {
  const scenes::Scene scene = mixture();
  for (const NamedLaw& law : all_laws()) {
    CAPTURE(law.name);
    check_all_targets(scene, law.settings);
  }
}

// Float has 2⁻¹⁹ nm between two numbers near 30 nm: coordinates in float would have 30 times the
// error of fixed point and differences.
TEST_CASE("forces are as accurate in a far corner of a large box and across its faces") {
  const Topology topology{
      {{read_molecule("tip4p"), 24}, {read_molecule("co2"), 10}, {read_molecule("argon"), 8}}};
  for (const Truncation truncation :
       {Truncation::molecule_switch, Truncation::site_switch, Truncation::site_shift}) {
    const ForceSettings settings{truncation, 0.75, 0.55, 2, Electrostatics::reaction_field,
                                 78.5,       0.1};
    const scenes::Scene drop = scenes::spread(topology, {1.5, 1.5, 1.5}, 41);
    check_all_targets(moved(drop, {30, 30, 30}, {27, 27.3, 27.7}), settings);
    check_all_targets(moved(drop, {30, 30, 30}, {29.2, -0.7, 29.1}), settings);
    check_all_targets(moved(drop, {30, 2.4, 2.1}, {-31, 2, 150.2}), settings);
  }
}

// Loops over sites are unrolled for common shapes of molecules, but not in the reference.
TEST_CASE("unrolled shapes of molecules equal the general path") {
  struct Case {
    std::string name;
    Molecule a, b;
    bool (*fits)(const PairTable&);
  };
  const auto model = [](const char* name) { return read_molecule(name); };
  const Molecule water = model("tip4p");
  const std::vector<Case> cases = {
      {"tip3p", model("tip3p"), model("tip3p"), FixedShape<3, 3, 1>::fits},
      {"spce", model("spce"), model("spce"), FixedShape<3, 3, 1>::fits},
      {"tip4p", water, water, FixedShape<4, 3, 1>::fits},
      {"tip5p", model("tip5p"), model("tip5p"), FixedShape<5, 4, 1>::fits},
      {"argon", model("argon"), model("argon"), FixedShape<1, 0, 1>::fits},
      {"ions", ion(), ion(), FixedShape<1, 1, 1>::fits},
      {"two sites", two_sites(), two_sites(), FixedShape<2, 2, 2>::fits},
      {"co2", model("co2"), model("co2"), FixedShape<3, 3, 3>::fits},
      {"n2", model("n2"), model("n2"), FixedShape<3, 3, 2>::fits},
      {"ions in water", water, ion(), FixedShape<4, 3, 1, 1, 1, 1>::fits},
      {"water around ions", ion(), water, FixedShape<1, 1, 1, 4, 3, 1>::fits}};
  for (const Case& c : cases) {
    CAPTURE(c.name);
    CHECK(c.fits(PairTable(c.a, c.b)));
    for (const Truncation truncation :
         {Truncation::molecule_switch, Truncation::site_switch, Truncation::site_shift}) {
      CAPTURE(int(truncation));
      const scenes::Scene scene = scenes::spread({{{c.a, 20}, {c.b, 17}}}, {1.56, 1.6, 1.7}, 12);
      check_all_targets(scene,
                        {truncation, 0.7, 0.6, 3, Electrostatics::reaction_field, 78.5, 0.05});
    }
  }
}

// Scaling box and centres by 1 + x at constant orientations scales every R by the same factor, so
// that dU/dx = −Σ R·f = −tr(virial). In a drop far from its images that is a displacement of the
// bodies alone, along which dual numbers yield dU to rounding.
TEST_CASE(
    "the trace of the virial is minus the derivative of the energy with respect to the logarithm "
    "of the length scale") {
  const scenes::Scene drop = moved(mixture(), {5, 5, 5}, {4.5, 4.6, 4.9});
  for (const NamedLaw& law : all_laws()) {
    CAPTURE(law.name);
    ForceField forces(drop.topology, law.settings, drop.state.box);
    Load load;
    forces(drop.state, load);
    const double trace = load.virial[0].x + load.virial[1].y + load.virial[2].z;
    const Load slope = reference_derivative(drop.topology, law.settings, drop.state, drop.state.q,
                                            Vec3Column(drop.state.size()));
    CHECK(std::abs(trace) > 0.1);
    CHECK(std::abs(slope.potential() + trace) < 1e-13 * terms_of(drop, law.settings).sum);
  }
}

// The same with images, by a central difference of fourth order. It errs by h⁴/30 of the fifth
// derivative, 12⁵ u for a term in R⁻¹², and by 1.5 roundings of U over h: 1e-11 of Σ |u| each. If a
// pair crosses an end of the switching range within 2 h, U has a kink of 35 (2 h R/width)⁴ u, over
// h: 1e-8 of that pair's u, a thousandth of all; classes 1 and 2 would have too large ones.
TEST_CASE(
    "the virial of a periodic liquid is the derivative of its energy with respect to the volume") {
  const scenes::Scene scene = mixture();
  for (const NamedLaw& law : all_laws()) {
    if (law.settings.smoothness < 3) continue;
    CAPTURE(law.name);
    const auto energy = [&](double x) {
      State state = scene.state;
      state.box = Box{(1 + x) * scene.state.box.edge};
      for (std::size_t i = 0; i < state.size(); ++i) state.q.set(i, (1 + x) * scene.state.q[i]);
      return load_of(scene.topology, law.settings, state).potential();
    };
    const double h = 5e-5;
    const double slope =
        (8 * (energy(h) - energy(-h)) - (energy(2 * h) - energy(-2 * h))) / (12 * h);
    const Mat3<double> virial = load_of(scene.topology, law.settings, scene.state).virial;
    const double trace = virial[0].x + virial[1].y + virial[2].z;
    CHECK(std::abs(trace) > 0.1);
    CHECK(std::abs(slope + trace) < 3e-11 * terms_of(scene, law.settings).sum);
  }
}
