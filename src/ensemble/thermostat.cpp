// SPDX-License-Identifier: MIT
#include "ensemble/thermostat.hpp"

#include "ensemble/velocity_rescaling.hpp"
#include "polhode/base/units.hpp"
#include "polhode/ensemble/random_streams.hpp"
#include "polhode/measure/energy.hpp"

namespace polhode {
namespace {

void scale(Vec3Column& v, double factor) {
  for (Component* column : {&v.x, &v.y, &v.z})
    for (std::size_t i = 0; i < v.size(); ++i) (*column)[i] *= factor;
}

/// Scales momenta and returns the heat.
double scale(State& state, const Thermostat::Motions& e, double a, double b) {
  scale(state.p, a);
  scale(state.ell, b);
  return (a * a - 1) * e.translation + (b * b - 1) * e.rotation;
}

}  // namespace

Thermostat::Thermostat(const ThermostatSettings& settings, double temperature,
                       const Topology& topology, const Bodies& bodies, std::uint64_t seed,
                       Workers& workers, TotalMomentum total_momentum)
    : settings_(settings),
      langevin_{
          .kT = units::boltzmann * temperature, .seed = seed, .total_momentum = total_momentum},
      degrees_of_freedom_(degrees_of_freedom(topology, total_momentum)),
      bodies_(bodies),
      workers_(workers) {
  if (const auto* friction = std::get_if<Langevin>(&settings)) {
    langevin_.friction = friction->friction;
    langevin_.rotational_friction = friction->rotational_friction;
  }
}

void Thermostat::operator()(State& state, double t, StageNumber at) {
  heat_ += std::visit([&](const auto& type) { return act(type, state, t, at); }, settings_);
}

double Thermostat::act(const Langevin&, State& state, double t, StageNumber at) const {
  return ornstein_uhlenbeck(state, bodies_, langevin_, t, stream_of(RandomUse::langevin, at),
                            workers_);
}

double Thermostat::act(const Rescaling& type, State& state, double t, StageNumber at) const {
  const Motions e = motions(state);
  const double a = factor(e.kinetic, degrees_of_freedom_.all(), t / type.time_constant,
                          stream_of(RandomUse::rescaling, at));
  return scale(state, e, a, a);
}

double Thermostat::act(const SeparateRescaling& type, State& state, double t,
                       StageNumber at) const {
  const Motions e = motions(state);
  const double n = degrees_of_freedom_.translation, time = t / type.time_constant;
  const double a = factor(e.translation, n, time, stream_of(RandomUse::rescaling, at));
  const double b = factor(e.rotation, degrees_of_freedom_.all() - n, time,
                          stream_of(RandomUse::separate_rescaling, at));
  return scale(state, e, a, b);
}

Thermostat::Motions Thermostat::motions(const State& state) const {
  Energies e = energies(state, bodies_, Load{}, workers_);
  e.translation += energy_of_centre(state, bodies_, langevin_.total_momentum);
  return {e.kinetic(), e.translation, e.kinetic() - e.translation};
}

double Thermostat::factor(double kinetic, double n, double time, std::uint64_t stream) const {
  return rescaling_factor(kinetic, n, langevin_.kT, time, Random(langevin_.seed, stream));
}

}  // namespace polhode
