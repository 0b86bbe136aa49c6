// SPDX-License-Identifier: MIT
#include "ensemble/thermostat.hpp"

#include "ensemble/velocity_rescaling.hpp"
#include "polhode/base/units.hpp"
#include "polhode/ensemble/random_streams.hpp"
#include "polhode/measure/energy.hpp"

namespace polhode {
namespace {

/// Kinetic energies of translation and rotation [kJ/mol]. These energies include the motion of the
/// centre of mass if it is free.
struct Motions {
  double kinetic, translation, rotation;
};

Motions motions(const State& state, const ThermostatBodies& of) {
  Energies e = energies(state, of.bodies, Load{}, of.workers);
  e.translation += energy_of_centre(state, of.bodies, of.langevin.total_momentum);
  return {e.kinetic(), e.translation, e.kinetic() - e.translation};
}

/// Scales the momenta and returns the heat.
double scaled_heat(State& state, const Motions& e, double a, double b) {
  scale(state.p, a);
  scale(state.ell, b);
  return (a * a - 1) * e.translation + (b * b - 1) * e.rotation;
}

/// The factor by which velocity rescaling multiplies momenta with n degrees of freedom. `kinetic`
/// is the kinetic energy of these momenta, and `time` is in units of the time constant.
double factor(double kinetic, double n, double time, const ThermostatBodies& of,
              std::uint64_t stream) {
  return rescaling_factor(kinetic, n, of.langevin.kT, time, Random(of.langevin.seed, stream));
}

// One function for each type of thermostat; each returns the heat that the bodies receive.

double act(const Langevin& type, const ThermostatBodies& of, State& state, double t,
           StageNumber at) {
  LangevinSettings settings = of.langevin;
  settings.friction = type.friction;
  settings.rotational_friction = type.rotational_friction;
  return ornstein_uhlenbeck(state, of.bodies, settings, t, stream_of(RandomUse::langevin, at),
                            of.workers);
}

double act(const Rescaling& type, const ThermostatBodies& of, State& state, double t,
           StageNumber at) {
  const Motions e = motions(state, of);
  const double a = factor(e.kinetic, of.degrees_of_freedom.all(), t / type.time_constant, of,
                          stream_of(RandomUse::thermostat, at));
  return scaled_heat(state, e, a, a);
}

double act(const SeparateRescaling& type, const ThermostatBodies& of, State& state, double t,
           StageNumber at) {
  const Motions e = motions(state, of);
  const double n = of.degrees_of_freedom.translation, time = t / type.time_constant;
  const double a = factor(e.translation, n, time, of, stream_of(RandomUse::thermostat, at));
  const double b = factor(e.rotation, of.degrees_of_freedom.all() - n, time, of,
                          stream_of(RandomUse::thermostat_rotation, at));
  return scaled_heat(state, e, a, b);
}

}  // namespace

Thermostat::Thermostat(const ThermostatSettings& settings, double temperature,
                       const Topology& topology, const Bodies& bodies, std::uint64_t seed,
                       Workers& workers, TotalMomentum total_momentum)
    : settings_(settings),
      of_{{.kT = units::boltzmann * temperature, .seed = seed, .total_momentum = total_momentum},
          degrees_of_freedom(topology, total_momentum),
          bodies,
          workers} {}

void Thermostat::operator()(State& state, double t, StageNumber at) {
  heat_ += std::visit([&](const auto& type) { return act(type, of_, state, t, at); }, settings_);
}

}  // namespace polhode
