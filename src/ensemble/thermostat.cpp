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

}  // namespace

Thermostat::Thermostat(const ThermostatSettings& settings, double temperature,
                       const Topology& topology, const Bodies& bodies, std::uint64_t seed,
                       Workers& workers, TotalMomentum total_momentum)
    : settings_(settings),
      langevin_{units::boltzmann * temperature, settings.friction, settings.rotational_friction,
                seed, total_momentum},
      degrees_of_freedom_(degrees_of_freedom(topology, total_momentum)),
      bodies_(bodies),
      workers_(workers) {}

void Thermostat::operator()(State& state, double t, StageNumber at) {
  switch (settings_.kind) {
    case ThermostatKind::langevin:
      heat_ += ornstein_uhlenbeck(state, bodies_, langevin_, t, stream_of(RandomUse::langevin, at),
                                  workers_);
      break;
    case ThermostatKind::rescaling:
    case ThermostatKind::separate_rescaling:
      heat_ += rescale(state, t, at);
      break;
  }
}

double Thermostat::rescale(State& state, double t, StageNumber at) const {
  Energies e = energies(state, bodies_, Load{}, workers_);
  e.translation += energy_of_centre(state, bodies_, langevin_.total_momentum);
  const double rotation = e.kinetic() - e.translation;
  const double n_translation = degrees_of_freedom_.translation;
  const double n_rotation = degrees_of_freedom_.all() - n_translation;
  const auto factor = [&](double kinetic, double n, RandomUse use) {
    return rescaling_factor(kinetic, n, langevin_.kT, t / settings_.time_constant,
                            Random(langevin_.seed, stream_of(use, at)));
  };
  double a = 1, b = 1;
  if (settings_.kind == ThermostatKind::separate_rescaling) {
    a = factor(e.translation, n_translation, RandomUse::rescaling);
    b = factor(rotation, n_rotation, RandomUse::separate_rescaling);
  } else {
    a = b = factor(e.kinetic(), n_translation + n_rotation, RandomUse::rescaling);
  }
  scale(state.p, a);
  scale(state.ell, b);
  return (a * a - 1) * e.translation + (b * b - 1) * rotation;
}

}  // namespace polhode
