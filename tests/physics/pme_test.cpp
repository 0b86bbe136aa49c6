// SPDX-License-Identifier: MIT
// PME in the force field: pairs, mesh and constants together.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "forces/laws/tail.hpp"
#include "forces/pairs/neighbours.hpp"
#include "instruction_sets.hpp"
#include "physics/force_laws.hpp"
#include "physics/mesh_scene.hpp"
#include "polhode/base/error.hpp"
#include "polhode/integrate/flows.hpp"
#include "polhode/integrate/integrator.hpp"
#include "polhode/integrate/schemes.hpp"
#include "polhode/model/centre_of_mass.hpp"

using namespace polhode;

namespace {

ForceSettings ewald(double cutoff, const MeshSettings& mesh) {
  ForceSettings settings{Truncation::site_switch, cutoff, 0.8 * cutoff, 2, Electrostatics::pme};
  settings.mesh = mesh;
  settings.mesh->cutoff = cutoff;
  return settings;
}

Topology without_charges(Topology topology) {
  for (auto& part : topology.parts)
    for (Site& site : part.molecule.sites) site.charge = 0;
  return topology;
}

// Lennard-Jones over all pairs and the classical Ewald sum, far more accurate than required: both
// parts are continued to e⁻³⁶ of their largest terms.
struct Direct {
  std::vector<Vec3<double>> f, tau;
  double van_der_waals, coulomb;
  double f_rms = 0;  // of electrostatic forces on sites

  Direct(const scenes::Scene& scene, const ForceSettings& settings) {
    const Box& box = scene.state.box;
    const auto lj =
        reference_load(without_charges(scene.topology), settings, box, scenes::poses(scene.state));
    f = lj.f, tau = lj.tau, van_der_waals = lj.van_der_waals;
    const PointCharges charges = point_charges(scene.topology, scene.state);
    const double alpha = 4;
    const EwaldSum sum = ewald_sum(charges, box, GaussianSplit{alpha}, {6 / alpha, 12 * alpha});
    coulomb = sum.energy.total();
    for (std::size_t k = 0; k < charges.size(); ++k) {
      const std::size_t i = charges.body[k];
      f[i] += sum.f[k];
      tau[i] += cross(charges.r[k] - scene.state.q[i], sum.f[k]);
      f_rms += norm2(sum.f[k]) / double(charges.size());
    }
    f_rms = std::sqrt(f_rms);
  }
};

double rms_error(const Vec3Column& of, const std::vector<Vec3<double>>& exact) {
  double sum = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) sum += norm2(of[i] - exact[i]);
  return std::sqrt(sum / double(exact.size()));
}

}  // namespace

// The required error is that of sites; that of a body is the sum over its charges, 3 here, and √3
// times as large if they are independent. Mixed precision has the error of float in Lennard-Jones
// contacts, about 1e-6 of the forces, below the smallest pme_accuracy allowed.
TEST_CASE("PME forces and energies equal the Ewald sum to the required accuracy") {
  for_each_instruction_set([] {
    const scenes::Scene scene = charged_mixture();
    for (const Precision precision : {Precision::double_precision, Precision::mixed})
      for (const double accuracy : {1e-3, 3e-5}) {
        CAPTURE(accuracy);
        ForceSettings settings{Truncation::site_switch, 0.7, 0.56, 2, Electrostatics::pme};
        settings.precision = precision;
        settings.pme_accuracy = accuracy;
        const Direct direct(scene, settings);
        ForceField forces(scene.topology, settings, scene.state.box);
        Load load, alone;
        forces(scene.state, load);
        forces.forces_alone(scene.state, alone);
        for (const Load* l : {&load, &alone}) {
          CHECK(rms_error(l->f, direct.f) < 1.8 * accuracy * direct.f_rms);
          CHECK(rms_error(l->f, direct.f) > 0.01 * accuracy * direct.f_rms);
          // Arms of charges are below 0.12 nm.
          CHECK(rms_error(l->tau, direct.tau) < 1.8 * 0.12 * accuracy * direct.f_rms);
        }
        // An error of the energy is at most a few arms times force errors, with random signs.
        const double bound = accuracy * direct.f_rms * std::sqrt(3.0 * double(scene.state.size()));
        CHECK(std::abs(load.coulomb - direct.coulomb) < bound);
        CHECK(load.van_der_waals ==
              doctest::Approx(direct.van_der_waals)
                  .epsilon(precision == Precision::double_precision ? 1e-12 : 1e-5));
      }
  });
}

// Whatever the accuracy, forces are the gradient of the energy: along the displacement f/m, J⁻¹ S τ
// the energy falls by Σ f²/m + τ·J⁻¹τ. A difference of fourth order leaves rounding of the energy.
TEST_CASE("forces with a coarse mesh are minus the gradient of the energy with the same mesh") {
  const scenes::Scene scene = charged_mixture();
  ForceField forces(scene.topology, ewald(0.7, {{16, 20, 16}, 4, 3}), scene.state.box);
  Load load, there;
  forces(scene.state, load);
  double slope = 0;
  for (std::size_t i = 0; i < scene.state.size(); ++i) {
    const Vec3<double> tau = to_body(scene.state.orientation[i], load.tau[i]);
    slope -= norm2(load.f[i]) * scene.bodies.inverse_m[i] +
             dot(tau, scaled(scene.bodies.inverse_J[i], tau));
  }
  const auto energy = [&](double c) {
    State moved = scene.state;
    displace(moved, scene.bodies, load, c);
    forces(moved, there);
    return there.potential();
  };
  const double h = 1e-7;
  const double numeric =
      (8 * (energy(h) - energy(-h)) - (energy(2 * h) - energy(-2 * h))) / (12 * h);
  const double rounding = 100 * 0x1p-53 * std::abs(load.potential()) / h;
  CHECK(std::abs(numeric - slope) < rounding + 1e-7 * std::abs(slope));
}

// The virial is the change of the energy when centres move with the box at constant orientations.
// Its trace equals the derivative of the energy with the same mesh; single components are as
// accurate as the mesh.
TEST_CASE("the virial is the change of the energy when the box is strained") {
  const scenes::Scene scene = charged_mixture();
  ForceSettings settings = ewald(0.7, {{32, 32, 32}, 7, 6});
  settings.dispersion_correction = true;
  Load load;
  ForceField(scene.topology, settings, scene.state.box)(scene.state, load);
  const auto energy = [&](const Vec3<double>& strain) {
    State moved = scene.state;
    const Vec3<double> factor = Vec3<double>{1, 1, 1} + strain;
    moved.box.edge = scaled(factor, moved.box.edge);
    for (std::size_t i = 0; i < moved.size(); ++i) moved.q.set(i, scaled(factor, moved.q[i]));
    Load there;
    ForceField(scene.topology, settings, moved.box)(moved, there);
    return there.potential();
  };
  const auto derivative = [&](const Vec3<double>& way) {
    const double h = 1e-5;
    return (8 * (energy(h * way) - energy(-h * way)) -
            (energy(2 * h * way) - energy(-2 * h * way))) /
           (12 * h);
  };
  const double trace = load.virial[0][0] + load.virial[1][1] + load.virial[2][2];
  const double scale = largest(load.f);
  CHECK(std::abs(derivative({1, 1, 1}) + trace) < 1e-6 * scale);
  for (std::size_t d = 0; d < 3; ++d) {
    Vec3<double> way{};
    way[d] = 1;
    CHECK(std::abs(derivative(way) + load.virial[d][d]) < 1e-3 * scale);
  }
}

TEST_CASE("PME gives the same bits for any number of threads") {
  const scenes::Scene scene = charged_mixture();
  for (const Precision precision : {Precision::double_precision, Precision::mixed}) {
    ForceSettings settings = ewald(0.7, {{20, 24, 20}, 5, 5});
    settings.precision = precision;
    Load one, many;
    ForceField(scene.topology, settings, scene.state.box)(scene.state, one);
    for (const int threads : {2, 3}) {
      Workers workers(threads);
      ForceField(scene.topology, settings, scene.state.box, workers)(scene.state, many);
      for (std::size_t i = 0; i < scene.state.size(); ++i) {
        CHECK(one.f[i] == many.f[i]);
        CHECK(one.tau[i] == many.tau[i]);
      }
      CHECK(one.potential() == many.potential());
      CHECK(one.virial[0][1] == many.virial[0][1]);
    }
  }
}

// Everything in one evaluation: rounding of 10³ kJ/mol/nm is 1e-13 in double, and in float that of
// the pairs and of the mesh, as in the tests of each.
TEST_CASE("charges may have a shorter or a longer cutoff than the short-range law") {
  const scenes::Scene scene = charged_mixture();
  for (const double coulomb_cutoff : {0.4, 0.7, 0.79}) {
    CAPTURE(coulomb_cutoff);
    ForceSettings settings = ewald(0.7, {{16, 20, 12}, 5, 6});
    settings.mesh->cutoff = coulomb_cutoff;
    BodyLoads mesh;
    const MeshLoad smooth = mesh_load<double>(scene.topology, scene.state, *settings.mesh, mesh);
    const auto pairs =
        reference_load(scene.topology, settings, scene.state.box, scenes::poses(scene.state));
    Load expected(scene.state.size());
    for (std::size_t i = 0; i < scene.state.size(); ++i) {
      expected.f.set(i, pairs.f[i] + mesh.f[i]);
      expected.tau.set(i, pairs.tau[i] + mesh.tau[i]);
    }
    remove_net_force(expected, scene.bodies, Workers::serial());
    BodyLoads bodies;
    for (std::size_t i = 0; i < scene.state.size(); ++i)
      bodies.f.push_back(expected.f[i]), bodies.tau.push_back(expected.tau[i]);
    for_each_instruction_set([&] {
      for (const Precision precision : {Precision::double_precision, Precision::mixed}) {
        CAPTURE(int(precision));
        settings.precision = precision;
        const double bound = precision == Precision::mixed ? 2e-5 : 1e-12;
        ForceField forces(scene.topology, settings, scene.state.box);
        Load load;
        forces(scene.state, load);
        const double energy = pairs.coulomb + smooth.energy + forces.constant_terms().coulomb();
        CHECK(std::abs(load.coulomb - energy) < bound * std::abs(smooth.energy));
        CHECK(std::abs(load.van_der_waals - pairs.van_der_waals) <
              bound * std::abs(pairs.van_der_waals));
        CHECK(largest_difference(load.f, bodies.f) < bound * largest(expected.f));
        CHECK(largest_difference(load.tau, bodies.tau) < bound * largest(expected.tau));
      }
    });
  }
}

// Bodies leave the box between two rebuilds of the list, so the mesh has positions outside of it.
TEST_CASE("after a long run at high temperature the mesh equals one built from the same state") {
  scenes::Scene scene = charged_mixture();
  for (std::size_t i = 0; i < scene.state.size(); ++i) scene.state.p.set(i, 3.0 * scene.state.p[i]);
  const ForceSettings settings = ewald(0.7, {{20, 24, 20}, 5, 5});
  ForceField forces(scene.topology, settings, scene.state.box);
  Integrator integrator(schemes[1], scene.bodies, forces);
  for (int k = 0; k < 20; ++k) {
    integrator.advance(scene.state, 0.0002, 20);
    const Load& load = integrator.load(scene.state);
    Load anew;
    ForceField(scene.topology, settings, scene.state.box)(scene.state, anew);
    for (std::size_t i = 0; i < scene.state.size(); ++i)
      CHECK(norm(load.f[i] - anew.f[i]) < 1e-10 * largest(load.f));
  }
  CHECK(forces.neighbours().rebuilds() > 2);
}

// With a switching range of zero width the tail is a textbook integral: 2π N²/V (c12/(9 r⁹) − c6/(3
// r³)).
TEST_CASE(
    "the long-range dispersion correction is the integral beyond the cutoff, divided by the "
    "volume") {
  const Topology argon{{{read_molecule("argon"), 50}}};
  const Site& site = argon.parts[0].molecule.sites[0];
  const auto [c6, c12] = LennardJones<>::of(site.sigma, site.epsilon);
  ForceSettings settings{Truncation::site_switch, 1.0, 1.0 - 1e-7};
  const double expected = 2 * units::pi * 2500 * (c12 / 9 - c6 / 3);
  CHECK(dispersion_tail(argon, settings) == doctest::Approx(expected).epsilon(1e-6));
  // And in a uniform fluid it compensates the truncation by a shorter cutoff: between 0.8 and 1 nm.
  settings.switch_from = 0.8;
  const double more = dispersion_tail(argon, settings);
  CHECK(more < expected);
  CHECK(more > 2 * expected);

  // The tail is kept, and each box divides it by its own volume.
  settings.dispersion_correction = true;
  ForceField forces(argon, settings, {{3.0, 3.1, 3.2}});
  Load load(50);
  for (const double edge : {3.0, 2.5}) {
    State state(50, {{edge, 3.1, 3.2}});
    for (std::size_t i = 0; i < 50; ++i)
      state.q.set(i, {0.5 * static_cast<double>(i % 5), 0.6 * static_cast<double>(i / 5 % 5),
                      1.0 * static_cast<double>(i / 25)});
    forces(state, load);
    CHECK(forces.constant_terms().dispersion == more / state.box.volume());
  }
}

TEST_CASE("unsupported settings of PME are refused") {
  const scenes::Scene scene = charged_mixture();
  ForceSettings settings{Truncation::molecule_switch, 0.7, 0.56, 2, Electrostatics::pme};
  CHECK_THROWS_AS(ForceField(scene.topology, settings, scene.state.box), Error);
  settings.truncation = Truncation::site_switch;
  settings.precision = Precision::mixed;
  settings.pme_accuracy = 1e-6;
  CHECK_THROWS_AS(ForceField(scene.topology, settings, scene.state.box), Error);
}

// Rock salt's energy is −1.747 564 594 6 K/d for each pair of ions at the distance d (Madelung's
// constant). Screened charges leave what the Gaussians' own lattice sum would add, e^(−k²/4α²) of
// the first wave vector k = π√3/d, 6e-11 here, and the truncation error: erfc(α a) of the shells of
// ions near a, whose charges partly cancel.
TEST_CASE("the damped shifted force reproduces the energy of rock salt") {
  const double d = 0.28;
  const auto ion = [](double charge) {
    return rigid_molecule("ion", {{.name = "I", .mass = 30, .charge = charge}});
  };
  const std::size_t edge = 12, half = edge * edge * edge / 2;
  const Topology salt{{{ion(1), half}, {ion(-1), half}}};
  State state(2 * half, Box{{edge * d, edge * d, edge * d}});
  std::size_t next[2] = {0, half};
  for (std::size_t i = 0; i < 2 * half; ++i) {
    const std::size_t x = i % edge, y = i / edge % edge, z = i / edge / edge;
    state.q.set(next[(x + y + z) % 2]++, d * Vec3<double>{double(x), double(y), double(z)});
  }
  for (const double cutoff : {1.0, 1.25, 1.5}) {
    ForceSettings settings{Truncation::site_switch, cutoff, 0.8 * cutoff, 1,
                           Electrostatics::damped_shifted_force};
    const Load load = load_of(salt, settings, state);
    const double madelung = -load.coulomb / double(half) * d / units::coulomb;
    const double off = std::abs(madelung - 1.7475645946),
                 left = std::erfc(settings.damping * cutoff);
    CHECK(off < 2 * left);
    CHECK(off > 0.02 * left);
    CHECK(largest(load.f) < 1e-9);
  }
}
