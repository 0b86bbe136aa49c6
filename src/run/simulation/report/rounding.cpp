// SPDX-License-Identifier: MIT
#include "polhode/run/simulation/report/rounding.hpp"

#include <cmath>
#include <vector>

#include "polhode/base/quaternion.hpp"
#include "polhode/base/units.hpp"
#include "polhode/integrate/flows.hpp"
#include "polhode/measure/energy.hpp"

namespace polhode {
namespace {

constexpr int states = 16;
constexpr double apart = 1e-4;  // time between the states [ps]

/// Sums over the states, from which the sample variance of a quantity follows.
struct Spread {
  double sum = 0, squares = 0;
  void add(double x) {
    sum += x;
    squares += x * x;
  }
  double variance() const { return (squares - sum * sum / states) / (states - 1); }
};

}  // namespace

ForceNoise force_noise(const System& system, Workers& workers) {
  if (system.forces.precision == Precision::double_precision ||
      system.bodies.size() > max_bodies_estimated)
    return {};
  const Bodies& bodies = system.bodies;
  const double T = temperature(energies(system.state, bodies, Load{}).kinetic(),
                               degrees_of_freedom(system.topology).all());
  ForceSettings in_double = system.forces;
  in_double.precision = Precision::double_precision;
  State state = system.state;
  ForceField rounded(system.topology, system.forces, state.box, workers);
  ForceField exact(system.topology, in_double, state.box, workers);

  const std::size_t n = bodies.size();
  Load a(n), b(n);
  std::vector<Spread> spreads(6 * n);
  Spread energy;
  for (int k = 0; k < states; ++k) {
    if (k > 0) drift(state, bodies, apart, workers);
    rounded(state, a);
    exact(state, b);
    energy.add(a.potential() - b.potential());
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3<double> df = a.f[i] - b.f[i];
      const Vec3<double> dtau = to_body(state.orientation[i], a.tau[i] - b.tau[i]);
      for (std::size_t c = 0; c < 3; ++c) {
        spreads[6 * i + c].add(df[c]);
        spreads[6 * i + 3 + c].add(dtau[c]);
      }
    }
  }
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      sum += spreads[6 * i + c].variance() * bodies.inverse_m[i] +
             spreads[6 * i + 3 + c].variance() * bodies.inverse_J[i][c];
  return {std::sqrt(units::boltzmann * T * sum), std::sqrt(energy.variance())};
}

double kick_weights(const Scheme& scheme, double lambda) {
  const auto stages = scheme.stages();
  double squares = 0, plain = 0, shifted = 0, first_plain = 0, first_shifted = 0;
  bool first = true;  // kicks before the first drift are added to kicks after the last drift
  const auto close = [&] {
    squares += plain * plain + shifted * shifted;
    plain = shifted = 0;
  };
  for (const Stage& stage : stages) {
    const bool gradient = stage.has(Gradient::finite_difference);
    switch (stage.flow) {
      case Flow::drift:
        if (first) {
          first_plain = plain, first_shifted = shifted;
          plain = shifted = 0;
          first = false;
        } else {
          close();
        }
        break;
      case Flow::kick:
        plain += stage.fraction * (gradient ? 1 - 1 / lambda : 1);
        shifted += gradient ? stage.fraction / lambda : 0;
        break;
      case Flow::bath:  // kicks before and after the bath are at the same positions
        break;
    }
  }
  plain += first_plain, shifted += first_shifted;
  close();
  return squares;
}

double kick_weights(const NestedScheme& scheme, double lambda) {
  double weights = kick_weights(scheme.outer, lambda);
  if (!scheme.inner) return weights;
  const double within = kick_weights(scheme.inner->scheme, lambda) / scheme.inner->steps;
  for (const Stage& stage : scheme.outer.stages())
    if (stage.flow == Flow::drift) weights += stage.fraction * stage.fraction * within;
  return weights;
}

double rounding_walk(const ForceNoise& noise, const NestedScheme& scheme, double lambda,
                     double step) {
  return noise.power * noise.power * step * kick_weights(scheme, lambda);
}

double double_drift(const Energies& e, double step) {
  return 16 * 0x1p-53 * (e.kinetic() + std::abs(e.van_der_waals) + std::abs(e.coulomb)) / step;
}

double double_walk(const Energies& e, double step) {
  return std::pow(double_drift(e, step), 2) * step;
}

double drift_rate(const EnergyStatistics& energies, double step) {
  const double rate = energies.drift().rate.value;
  return std::abs(rate) > double_drift(energies.first, step) ? rate : 0;
}

double walk_fluctuation(double rate, double length) { return std::sqrt(rate * length / 6); }

double rounding_fluctuation(const ForceNoise& noise, const NestedScheme& scheme, double lambda,
                            double step, double length) {
  return std::hypot(walk_fluctuation(rounding_walk(noise, scheme, lambda, step), length),
                    noise.energy);
}

}  // namespace polhode
