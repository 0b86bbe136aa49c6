// SPDX-License-Identifier: MIT
// The result of any force evaluation: forces, torques, the potential by term, and the virial.
#pragma once

#include "polhode/base/column.hpp"

namespace polhode {

struct Load {
  Vec3Column f;              ///< force on each body [kJ/mol/nm], lab frame
  Vec3Column tau;            ///< torque on each body about its centre of mass [kJ/mol], lab frame
  double van_der_waals = 0;  ///< energy of the short-range potentials [kJ/mol]
  double coulomb = 0;        ///< electrostatic energy [kJ/mol]
  double mesh = 0;           ///< reciprocal-space (mesh) part of `coulomb` [kJ/mol]
  double external = 0;       ///< energy of ExternalForces [kJ/mol]
  /// The molecular virial [kJ/mol]. The virial is −dU/dε for a strain ε that moves the centres and
  /// keeps the orientations. For pair forces the virial is Σ R ⊗ f over pairs of bodies, where R is
  /// the vector between the centres and f is the force on the second body. The pressure tensor is
  /// (Σ p ⊗ p/m + virial)/V.
  Mat3<double> virial{};

  Load() = default;
  explicit Load(std::size_t bodies) : f(bodies), tau(bodies) {}
  double potential() const { return van_der_waals + coulomb + external; }
};

}  // namespace polhode
