// SPDX-License-Identifier: MIT
// This part of fix polhode applies the bath, which holds the temperature of the bodies.
#include <array>
#include <string_view>

#include "ensemble/velocity_rescaling.hpp"
#include "error.h"
#include "fix_polhode.hpp"
#include "force.h"
#include "polhode/ensemble/langevin.hpp"
#include "polhode/ensemble/random_streams.hpp"
#include "polhode/model/centre_of_mass.hpp"
#include "update.h"

namespace polhode::lammps {

/// kT of the bath in units of LAMMPS without mvv2e, at the present step of a run.
double FixPolhode::bath_kT() const {
  const BathArguments& bath = *settings_.bath;
  double T = bath.temperature;
  if (bath.last && update->endstep > update->beginstep)
    T += (*bath.last - T) * static_cast<double>(update->ntimestep - update->beginstep) /
         static_cast<double>(update->endstep - update->beginstep);
  return force->boltz * T / force->mvv2e;
}

/// LAMMPS lets users give a thermostat or a barostat another compute for its measurements.
int FixPolhode::modify_param(int, char** arguments) {
  const std::string_view name = arguments[0];
  if (name == "temp" || name == "press")
    error->all(
        FLERR,
        "fix polhode measures the temperature and the pressure of its bodies itself, for all "
        "of its bodies, so 'fix_modify {} {}' has no effect; remove it",
        id, name);
  return 0;
}

void FixPolhode::bath(double t, StageNumber at) {
  const double heat =
      settings_.bath->type == BathType::langevin ? add_friction(t, at) : rescale(t, at);
  heat_ += force->mvv2e * heat;
}

/// Applies the Ornstein-Uhlenbeck flow. It conserves the total momentum if all atoms are in bodies.
/// @return  heat that the bodies of all processes receive
double FixPolhode::add_friction(double t, StageNumber at) {
  const double friction = 1 / settings_.bath->time_constant;
  BodyColumns& c = *columns_;
  LangevinSettings flow{bath_kT(), friction, friction, settings_.bath->seed, TotalMomentum::free};
  flow.numbers = c.numbers.data();
  const double here =
      ornstein_uhlenbeck(c.state, c.bodies, flow, t, stream_of(RandomUse::langevin, at));
  const Vec3<double> P = total_momentum(c.state);
  std::array sums{here, P.x, P.y, P.z, c.size() > 0 ? total_mass(c.bodies) : 0.0};
  MPI_Allreduce(MPI_IN_PLACE, sums.data(), 5, MPI_DOUBLE, MPI_SUM, world);
  if (!has_all_atoms_ || sums[4] == 0) return sums[0];
  const Vec3<double> all{sums[1], sums[2], sums[3]};
  subtract_velocity(c.state, c.bodies, all / sums[4]);
  return sums[0] - norm2(all) / (2 * sums[4]);
}

/// Scales all momenta by one random factor [bussi2007]. The motion of the centre of mass has no
/// part in the temperature if all atoms are in bodies.
/// @return  heat that the bodies of all processes receive
double FixPolhode::rescale(double t, StageNumber at) {
  BodyColumns& c = *columns_;
  double kinetic = 0;
  for (std::size_t i = 0; i < c.size(); ++i)
    kinetic += (dot(c.state.p[i], c.velocity(i)) + dot(c.state.ell[i], c.angular_velocity(i))) / 2;
  const Vec3<double> P = total_momentum(c.state);
  std::array sums{
      kinetic, degrees_of_freedom_, P.x, P.y, P.z, c.size() > 0 ? total_mass(c.bodies) : 0.0};
  MPI_Allreduce(MPI_IN_PLACE, sums.data(), 6, MPI_DOUBLE, MPI_SUM, world);
  double all = sums[0], n = sums[1];
  if (has_all_atoms_) {
    n -= 3;
    all -= (sums[2] * sums[2] + sums[3] * sums[3] + sums[4] * sums[4]) / (2 * sums[5]);
  }
  const BathArguments& bath = *settings_.bath;
  double factor = rescaling_factor(all, n, bath_kT(), t / bath.time_constant,
                                   Random(bath.seed, stream_of(RandomUse::thermostat, at)));
  MPI_Bcast(&factor, 1, MPI_DOUBLE, 0, world);  // the same to the last bit
  for (std::size_t i = 0; i < c.size(); ++i) {
    c.state.p.set(i, factor * c.state.p[i]);
    c.state.ell.set(i, factor * c.state.ell[i]);
  }
  return (factor * factor - 1) * sums[0];
}

}  // namespace polhode::lammps
