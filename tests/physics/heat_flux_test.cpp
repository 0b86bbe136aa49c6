// SPDX-License-Identifier: MIT
// The heat flux against the energy and virial of a moving system, against the motion of energy in a
// cluster, and against itself with other splits of the electrostatics.
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "instruction_sets.hpp"
#include "measure/zero_frequency.hpp"
#include "physics/force_laws.hpp"
#include "polhode/forces/force_field.hpp"
#include "polhode/forces/heat_flux.hpp"
#include "polhode/integrate/integrator.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/math/fit.hpp"
#include "polhode/model/centre_of_mass.hpp"
#include "run/properties/low_frequency_spectrum.hpp"
#include "unit/errors.hpp"

using namespace polhode;

namespace {

double kinetic_energy(const scenes::Scene& scene, std::size_t i) {
  const State& s = scene.state;
  const Vec3<double> L = to_body(s.orientation[i], s.ell[i]);
  return dot(s.p[i], s.p[i]) / (2 * scene.bodies.m[i]) +
         dot(L, scaled(scene.bodies.inverse_J[i], L)) / 2;
}

/// Laws of fluids with one kind of molecule: all truncations, and PME.
std::vector<NamedLaw> laws() {
  std::vector<NamedLaw> list = all_laws();
  ForceSettings pme{.truncation = Truncation::site_switch, .cutoff = 0.75, .switch_from = 0.6};
  pme.electrostatics = Electrostatics::pme;
  for (const double accuracy : {1e-4, 1e-6}) {
    pme.pme_accuracy = accuracy;
    list.push_back({"PME to " + std::to_string(accuracy), pme});
  }
  return list;
}

scenes::Scene fluid(const std::string& name, double edge, std::size_t count) {
  return scenes::spread({{{read_molecule(name), count}}}, {edge, edge, edge}, 5);
}

Vec3<double> flux_of(const Topology& topology, const ForceSettings& settings, const State& state,
                     double share = 0.5) {
  ForceField forces(topology, settings, state.box);
  return HeatFlux(topology, forces.settings(), state.box, share)(state);
}

/// Steps with momenta that are scaled to a temperature at intervals; molecules are linear.
void equilibrate(scenes::Scene& scene, Integrator<ForceField>& integrator, double temperature,
                 double step) {
  const auto cooled = [&](const Vec3Column& p, double factor) {
    Vec3Column slower = p;
    for (std::size_t i = 0; i < p.size(); ++i) slower.set(i, factor * p[i]);
    return slower;
  };
  remove_total_momentum(scene.state, scene.bodies);
  for (int k = 0; k < 200; ++k) {
    double kinetic = 0;
    for (std::size_t i = 0; i < scene.state.size(); ++i) kinetic += kinetic_energy(scene, i);
    const double wanted =
        (5 * static_cast<double>(scene.state.size()) - 3) / 2 * units::boltzmann * temperature;
    scene.state.p = cooled(scene.state.p, std::sqrt(wanted / kinetic));
    scene.state.ell = cooled(scene.state.ell, std::sqrt(wanted / kinetic));
    integrator.advance(scene.state, step, 50);
  }
}

}  // namespace

// If all molecules move with the same velocity u and do not rotate, they carry their energy E, and
// do the work of their virial W on each other: J V = (E + W) u. The sums are the same in another
// order, so they agree to rounding. With a mesh they agree to the accuracy of its forces, because
// the change of the charges is computed from the slopes of splines, and the virial from wave
// vectors. An error ε of the typical force F on each of n charges changes W by about ε F √n L/2;
// four times that allows for errors that are not independent.
TEST_CASE("heat flux: of a system that moves as a whole") {
  const Vec3<double> u{0.3, -0.7, 0.5};
  for (const std::string name : {"argon", "spce", "tip4p", "co2", "benzene"})
    for (const NamedLaw& law : laws()) {
      const bool has_mesh = law.settings.electrostatics == Electrostatics::pme;
      if (has_mesh && name == "argon") continue;
      CAPTURE(name);
      CAPTURE(law.name);
      scenes::Scene scene = fluid(name, 2, 60);
      double kinetic = 0;
      for (std::size_t i = 0; i < scene.state.size(); ++i) {
        scene.state.p.set(i, scene.bodies.m[i] * u);
        scene.state.ell.set(i, {});
        kinetic += kinetic_energy(scene, i);
      }
      ForceField forces(scene.topology, law.settings, scene.state.box);
      Load load(scene.state.size());
      forces(scene.state, load);
      const ConstantTerms& constant = forces.constant_terms();
      Mat3<double> W = load.virial;
      for (std::size_t d = 0; d < 3; ++d) W[d] -= constant.virial[d];
      const Vec3<double> expected =
          (kinetic + load.potential() - constant.coulomb() - constant.dispersion) * u + W * u;
      double allowed = 1e-12 * (norm(expected) + kinetic);
      if (has_mesh) {
        const std::size_t n = 60 * InteractionSites(scene.topology.parts.front().molecule).charged;
        allowed = 4 * law.settings.pme_accuracy * typical_force(scene.topology, scene.state.box) *
                  std::sqrt(static_cast<double>(n)) * norm(u);
      }
      for (const double share : {0.5, 1.0}) {
        HeatFlux flux(scene.topology, forces.settings(), scene.state.box, share);
        CHECK(norm(flux(scene.state) - expected) < allowed);
      }
    }
}

// In a cluster whose molecules have no images within range, the flux is the derivative of Σ e_i
// r_i. The energy of the pairs of a molecule is the energy of the cluster minus that without it.
// Central differences of fourth order at steps of 0.05 fs have errors of 1e-9 of the flux here.
TEST_CASE("heat flux: of a cluster, the motion of its energy") {
  for (const NamedLaw& law : all_laws())
    for (const double share : {0.5, 1.0}) {
      CAPTURE(law.name);
      CAPTURE(share);
      const scenes::Scene scene = scenes::lattice({{"tip4p", 6}}, 0.34, 6, 7);
      const std::size_t n = scene.state.size();
      const auto pair = [&](const State& state, std::size_t i, std::size_t j) {
        const Topology two{{{scene.topology.parts.front().molecule, 2}}};
        State both(2, state.box);
        for (const std::size_t k : {i, j}) {
          both.q.set(k == j, state.q[k]);
          both.orientation.set(k == j, state.orientation[k]);
        }
        ForceField forces(two, law.settings, state.box);
        Load load(2);
        forces(both, load);
        return load.potential() - forces.constant_terms().coulomb();
      };
      const auto moment = [&](const State& state) {
        const scenes::Scene now{scene.topology, scene.bodies, state};
        Vec3<double> sum{};
        for (std::size_t i = 0; i < n; ++i) {
          sum += kinetic_energy(now, i) * state.q[i];
          for (std::size_t j = i + 1; j < n; ++j)
            sum += pair(state, i, j) * (share * state.q[i] + (1 - share) * state.q[j]);
        }
        return sum;
      };
      const auto after = [&](double time) {
        State state = scene.state;
        ForceField forces(scene.topology, law.settings, state.box);
        Integrator integrator(scheme_of("hoa2"), scene.bodies, forces);
        integrator.advance(state, time / 4, 4);
        return state;
      };
      const double h = 5e-5;
      const Vec3<double> expected = (8.0 * (moment(after(h)) - moment(after(-h))) -
                                     (moment(after(2 * h)) - moment(after(-2 * h)))) /
                                    (12 * h);
      const Vec3<double> flux = flux_of(scene.topology, law.settings, scene.state, share);
      CHECK(norm(flux - expected) < 1e-6 * norm(expected));
    }
}

// The flux does not depend on the split of 1/r between pairs and mesh. Pairs beyond the shorter
// cutoff are then part of the mesh, with all their images. The error is that of the mesh, a
// fraction 1e-5 of the forces.
TEST_CASE("heat flux: with any split of the electrostatics") {
  scenes::Scene scene = fluid("spce", 2, 200);
  remove_total_momentum(scene.state, scene.bodies);
  ForceSettings settings{.truncation = Truncation::site_switch, .cutoff = 0.8, .switch_from = 0.7};
  settings.electrostatics = Electrostatics::pme;
  std::vector<Vec3<double>> flux;
  for (const double cutoff : {0.7, 0.85}) {
    settings.mesh = mesh_for(1e-5, cutoff, scene.state.box, scene.topology);
    flux.push_back(flux_of(scene.topology, settings, scene.state));
  }
  CHECK(norm(flux[0] - flux[1]) < 1e-4 * norm(flux[0]));
  // The mesh contributes much more than this difference.
  settings.electrostatics = Electrostatics::reaction_field;
  settings.mesh.reset();
  CHECK(norm(flux_of(scene.topology, settings, scene.state) - flux[0]) > 1e-2 * norm(flux[0]));
}

TEST_CASE("heat flux: the same by all instruction sets") {
  const scenes::Scene scene = fluid("tip4p", 2, 100);
  const ForceSettings settings{
      .truncation = Truncation::molecule_switch, .cutoff = 0.8, .switch_from = 0.7};
  std::vector<Vec3<double>> flux;
  for_each_instruction_set([&] { flux.push_back(flux_of(scene.topology, settings, scene.state)); });
  for (const Vec3<double>& other : flux) CHECK(norm(other - flux[0]) < 1e-12 * norm(flux[0]));
}

TEST_CASE("heat flux: what it is not defined for is an error") {
  const scenes::Scene scene = mixture();
  check_error([&] { HeatFlux(scene.topology, {}, scene.state.box); },
              {"one kind of molecule", "partial enthalpies"});
  const Topology water{{{read_molecule("spce"), 10}}};
  ForceSettings settings;
  settings.electrostatics = Electrostatics::pme;
  check_error([&] { HeatFlux(water, settings, scene.state.box); },
              {"the mesh of PME", "ForceField"});
  settings = {};
  settings.slab_dispersion = true;
  check_error([&] { HeatFlux(water, settings, scene.state.box); },
              {"slab_dispersion", "dispersion_correction"});
  HeatFlux flux(water, {}, Box{Vec3<double>{3, 3, 3}});
  check_error([&] { flux(State(10, Box{Vec3<double>{4, 4, 4}})); }, {"another box"});
}

// The thermal conductivity does not depend on which molecule of a pair has its energy: the heat
// flux changes by the derivative of a bounded quantity, which has no spectrum at zero frequency
// [marcolongo2016]. Here one molecule of a pair has all of it, or both have a half. Four errors of
// the difference by the jackknife over segments, with eleven degrees of freedom: by chance in 1 of
// 500 tests, and the seed is fixed. The flux itself changes much more.
TEST_CASE("heat flux: the conductivity does not depend on the share of pair energies") {
  constexpr std::size_t segments = 12, samples = 4096;
  constexpr double temperature = 80, step = 0.008;
  scenes::Scene scene = fluid("n2", 1.229, 32);  // 0.8 g/cm³
  const ForceSettings settings{
      .truncation = Truncation::molecule_switch, .cutoff = 0.6, .switch_from = 0.5};
  ForceField forces(scene.topology, settings, scene.state.box);
  Integrator integrator(scheme_of("hoa2"), scene.bodies, forces);
  equilibrate(scene, integrator, temperature, step);
  const ModeBins bins(samples / 8);
  std::vector<std::vector<double>> spectra[2];
  double square[2] = {0, 0};
  HeatFlux flux[2] = {{scene.topology, settings, scene.state.box, 0.5},
                      {scene.topology, settings, scene.state.box, 1}};
  for (std::size_t k = 0; k < segments; ++k) {
    LowFrequencySpectrum<3> spectrum[2] = {{samples, step}, {samples, step}};
    for (std::size_t n = 0; n < samples; ++n) {
      integrator.advance(scene.state, step);
      for (std::size_t which : {0u, 1u}) {
        const Vec3<double> J = flux[which](scene.state);
        spectrum[which].add({J.x, J.y, J.z});
        square[which] += norm2(J);
      }
    }
    for (std::size_t which : {0u, 1u}) spectra[which].push_back(spectrum[which].means(bins));
  }
  const auto mean = [&](std::size_t which, std::size_t without) {
    std::vector<double> sum(bins.size());
    for (std::size_t k = 0; k < segments; ++k)
      for (std::size_t b = 0; k != without && b < sum.size(); ++b) sum[b] += spectra[which][k][b];
    return sum;
  };
  const auto values = [&](std::size_t without) {
    std::vector<double> both;
    for (std::size_t which : {0u, 1u}) {
      const ZeroFrequency fit(mean(which, segments), 3.0 * segments, bins);
      both.push_back(fit.value(mean(which, without)));
    }
    return both;
  };
  std::vector<double> differences;
  for (std::size_t k = 0; k < segments; ++k) {
    const auto both = values(k);
    differences.push_back(both[1] / both[0]);
  }
  const auto all = values(segments);
  const double difference = all[1] / all[0] - 1, error = jackknife_error(differences);
  CHECK(std::abs(difference) < 4 * error);
  CHECK(error < 0.03);
  CHECK(square[1] > 1.5 * square[0]);
}
