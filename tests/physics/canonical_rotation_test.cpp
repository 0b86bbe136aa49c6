// SPDX-License-Identifier: MIT
// The canonical distribution of orientations in an orientational well, for every kind of top.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "ensemble/thermostat.hpp"
#include "hybrid_sampling.hpp"
#include "polhode/base/units.hpp"
#include "polhode/ensemble/hybrid_monte_carlo.hpp"
#include "polhode/integrate/integrator.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "scenes.hpp"

using namespace polhode;

namespace {

using scenes::kelvin;
using scenes::kT;
constexpr double depth = 4 * kT;

// U = −k (x·e_x + z·e_z) for the first and third principal axes x, z of each body; a linear body,
// whose axis is the first, has the first term only.
struct Well {
  bool linear;
  void operator()(const State& state, Load& load) const {
    load.van_der_waals = 0;
    for (std::size_t i = 0; i < state.size(); ++i) {
      Vec3<double> torque;
      const auto pull = [&](const Vec3<double>& e) {
        const Vec3<double> a = to_lab(state.orientation[i], e);
        load.van_der_waals -= depth * dot(a, e);
        torque += depth * cross(a, e);
      };
      pull({1, 0, 0});
      if (!linear) pull({0, 0, 1});
      load.f.set(i, {});
      load.tau.set(i, torque);
    }
  }
  // −⟨U⟩/k of one body. The sums over the Euler angles α and γ converge exponentially, the midpoint
  // rule in cos β errs by 1e-5.
  double exact() const {
    constexpr double a = depth / kT;
    if (linear) return 1 / std::tanh(a) - 1 / a;
    constexpr int points = 40, levels = 400;
    double weight = 0, sum = 0;
    for (int i = 0; i < points; ++i)
      for (int j = 0; j < points; ++j)
        for (int l = 0; l < levels; ++l) {
          const double alpha = 2 * units::pi * i / points, gamma = 2 * units::pi * j / points;
          const double c = 2 * (l + 0.5) / levels - 1;
          const double u =
              std::cos(alpha) * c * std::cos(gamma) - std::sin(alpha) * std::sin(gamma) + c;
          weight += std::exp(a * u), sum += u * std::exp(a * u);
        }
    return sum / weight;
  }
};

scenes::Scene tops(const std::string& molecule, std::size_t count) {
  scenes::Scene scene = scenes::lattice({{molecule, count}}, 1, 100, 1);
  for (std::size_t i = 0; i < count; ++i) scene.state.orientation.set(i, {});  // the minimum of U
  return scene;
}

// Of the fastest libration: √((k + k)/J) about the second axis, √(k/J) about the others.
double step_of(const scenes::Scene& scene, double omega_h) {
  const Vec3<double> J = scene.bodies.J[0];
  const double stiffness =
      std::max({J.x > 0 ? depth / J.x : 0, (J.x > 0 ? 2 : 1) * depth / J.y, depth / J.z});
  return omega_h / std::sqrt(stiffness);
}

constexpr const char* molecules[] = {"tip4p", "benzene", "co2", "ccl4"};  // of every kind

bool linear(const scenes::Scene& scene) { return scene.bodies.J[0].x == 0; }

}  // namespace

// A deviation of 4 standard errors, known to 20 %, occurs by chance in 1 of 1,000 checks.
TEST_CASE("hybrid Monte Carlo samples orientations exactly, with steps that are often rejected") {
  for (const char* molecule : molecules)
    for (const double refresh : {1.0, 0.5}) {
      CAPTURE(std::string(molecule));
      CAPTURE(refresh);
      const scenes::Scene scene = tops(molecule, 4);
      const Well well{linear(scene)};
      const double h = step_of(scene, 1.4);
      HybridMonteCarlo hybrid({.steps = 3, .refresh = refresh}, kelvin, scene.bodies, 5);
      Integrator integrator(scheme_of("velocity-verlet"), scene.bodies, well);
      State state = scene.state;
      TimeBlocks blocks;
      constexpr std::uint64_t trajectories = 20000;
      sample_hybrid(hybrid, integrator, state, {h, 3, trajectories},
                    [&](const State& now, const Load& load) {
                      blocks.add(std::array{-load.potential() / (depth * double(now.size()))});
                    });
      const SeriesEstimate u = series_estimate(blocks.means(), [](auto mean) { return mean[0]; });
      const double accepted = double(hybrid.memory().accepted) / trajectories;
      CAPTURE(u.value);
      CAPTURE(u.error);
      CAPTURE(accepted);
      CHECK(std::abs(u.value - well.exact()) < 4 * u.error);
      CHECK(u.error < 0.01 * well.exact());
      CHECK(accepted > 0.3);
      CHECK(accepted < 0.9);
    }
}

// The bias of a short step, by the harmonic law for the fastest libration: (ωh)²/4 of the thermal
// energy, and of the kinetic energy.
TEST_CASE("in a bath, orientations and momenta about each axis are canonical for short steps") {
  constexpr double omega_h = 0.15, bias = omega_h * omega_h / 4;
  for (const char* molecule : molecules)
    for (const char* scheme : {"obabo", "baoab"}) {
      CAPTURE(std::string(molecule));
      CAPTURE(std::string(scheme));
      const scenes::Scene scene = tops(molecule, 200);
      const Well well{linear(scene)};
      const double h = step_of(scene, omega_h);
      Thermostat thermostat(Langevin{0.2 / h, 0.2 / h}, kelvin, scene.topology, scene.bodies, 5);
      const auto bath = [&](State& state, double t, StageNumber at) { thermostat(state, t, at); };
      Integrator integrator(scheme_of(scheme), scene.bodies, well,
                            FreeDrift{scene.bodies, Workers::serial()}, bath);
      State state = scene.state;
      integrator.advance(state, h, 200);
      constexpr int samples = 30;
      const double n = samples * double(state.size());
      double u = 0, squares = 0;
      Vec3<double> kinetic;  // L_k²/(J_k kT), mean 1, variance 2
      for (int k = 0; k < samples; ++k) {
        integrator.advance(state, h, 50);  // 5 relaxation times of an energy
        for (std::size_t i = 0; i < state.size(); ++i) {
          State one(1, state.box);
          Load load(1);
          one.orientation.set(0, state.orientation[i]);
          well(one, load);
          const double value = -load.potential() / depth;
          u += value / n, squares += value * value / n;
          const Vec3<double> L = to_body(state.orientation[i], state.ell[i]);
          for (std::size_t c = 0; c < 3; ++c)
            if (scene.bodies.J[i][c] > 0)
              kinetic[c] += L[c] * L[c] / (scene.bodies.J[i][c] * kT * n);
        }
      }
      const double error = std::sqrt((squares - u * u) / n), top = well.linear ? 1 : 2;
      CAPTURE(u);
      CAPTURE(error);
      CHECK(std::abs(u - well.exact()) < 4 * error + bias * (top - well.exact()));
      for (std::size_t c = 0; c < 3; ++c) {
        const double expected = scene.bodies.J[0][c] > 0 ? 1 : 0;
        CHECK(std::abs(kinetic[c] - expected) < 4 * std::sqrt(2 / n) + bias);
      }
    }
}

// The rounding of each step is forgotten with the friction, here after 10 steps.
TEST_CASE("a linear molecule in a bath has no momentum about its axis after 10,000 steps") {
  const scenes::Scene scene = tops("co2", 8);
  const Well well{true};
  const double h = step_of(scene, 0.5);
  Thermostat thermostat(Langevin{0.1 / h, 0.1 / h}, kelvin, scene.topology, scene.bodies, 5);
  const auto bath = [&](State& state, double t, StageNumber at) { thermostat(state, t, at); };
  Integrator integrator(scheme_of("baoab"), scene.bodies, well,
                        FreeDrift{scene.bodies, Workers::serial()}, bath);
  State state = scene.state;
  integrator.advance(state, h, 10000);
  for (std::size_t i = 0; i < state.size(); ++i) {
    const Vec3<double> L = to_body(state.orientation[i], state.ell[i]);
    CAPTURE(L.x / norm(state.ell[i]));
    const double thermal = std::sqrt(scene.bodies.J[i].y * kT);
    CHECK(std::abs(L.x) < 10 * 8 * std::numeric_limits<double>::epsilon() * thermal);
  }
}
