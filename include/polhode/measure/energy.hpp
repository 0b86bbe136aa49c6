// SPDX-License-Identifier: MIT
// Energies and momenta of a state, relative to the centre of mass of all bodies.
#pragma once

#include <array>
#include <limits>

#include "polhode/base/workers.hpp"
#include "polhode/model/centre_of_mass.hpp"
#include "polhode/model/degrees_of_freedom.hpp"
#include "polhode/model/load.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

struct Energies {
  double time = 0;                 ///< time of the sample [ps]
  double van_der_waals = 0;        ///< energy of the short-range potentials [kJ/mol]
  double coulomb = 0;              ///< electrostatic energy [kJ/mol]
  double translation = 0;          ///< kinetic energy of translation, Σ p²/2m [kJ/mol]
  std::array<double, 3> rotation;  ///< kinetic energy of rotation about each principal axis, Σ
                                   ///< L_k²/2J_k [kJ/mol]
  double pressure = 0;             ///< a third of the trace of the pressure tensor [kJ/mol/nm³]
  double volume = 0;               ///< volume of the box [nm³]
  /// Heat and work that a thermostat, a barostat or hybrid Monte Carlo has given to the bodies
  /// since the start [kJ/mol].
  double exchanged = 0;
  /// The difference H̃ − H of shadow energy and energy [kJ/mol]; NaN at samples without a shadow
  /// energy.
  double step_error = std::numeric_limits<double>::quiet_NaN();
  double external = 0;  ///< energy of ExternalForces [kJ/mol]

  double potential() const { return van_der_waals + coulomb + external; }
  double kinetic() const { return translation + rotation[0] + rotation[1] + rotation[2]; }
  double total() const { return potential() + kinetic(); }
  /// The conserved energy, which exact flows would conserve [bussi2007]. Without thermostat and
  /// barostat, the conserved energy is the total energy.
  double conserved() const { return total() - exchanged; }
};

/// Computes the energies of a state, given the Load at its positions. Fixed blocks are summed in
/// order, so the result is bitwise identical for any number of threads.
Energies energies(const State& state, const Bodies& bodies, const Load& load,
                  Workers& workers = Workers::serial());

/// The kinetic energy P²/2M of the centre of mass [kJ/mol], which energies() does not include; 0 if
/// the total momentum is held at 0.
double energy_of_centre(const State& state, const Bodies& bodies, TotalMomentum total_momentum);

/// The molecular pressure tensor (Σ p ⊗ p/m − P ⊗ P/M + virial)/V [kJ/mol/nm³]
/// [allen2017, section 2.7], with momenta relative to the centre of mass. The Load contains the
/// virial only if it was computed with energies.
Mat3<double> pressure_tensor(const State& state, const Bodies& bodies, const Load& load);

/// The total angular momentum Σ q × p + ℓ about the origin [u nm²/ps].
Vec3<double> total_angular_momentum(const State& state);

/// The temperature 2 E/(n k_B) [K] of a kinetic energy E with n degrees of freedom; 0 without
/// degrees of freedom.
double temperature(double kinetic_energy, double degrees_of_freedom);

/// Temperatures by kind of motion [K]; 0 without degrees of freedom.
struct Temperatures {
  double all = 0;
  double translation = 0;
  std::array<double, 3> rotation{};  ///< temperature of rotation about each principal axis
};

/// Computes temperatures from means of the kinetic energies.
Temperatures mean_temperatures(const Energies& mean, const DegreesOfFreedom& degrees_of_freedom);

}  // namespace polhode
