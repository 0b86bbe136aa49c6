// SPDX-License-Identifier: MIT
// The Ornstein-Uhlenbeck flow O of momenta: friction and noise in exact balance.
#pragma once

#include <cstdint>

#include "polhode/base/workers.hpp"
#include "polhode/integrate/step.hpp"
#include "polhode/model/degrees_of_freedom.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

struct LangevinSettings {
  double kT = 0;                   ///< thermal energy k_B T [kJ/mol]
  double friction = 0;             ///< friction γ of translation [1/ps]
  double rotational_friction = 0;  ///< friction γ of rotation [1/ps]
  std::uint64_t seed = 0;
  TotalMomentum total_momentum = TotalMomentum::held;
  /// The number of each body, in a padded Column. The number of a body, rather than its place in
  /// the column, selects its random numbers. If this column is null, the numbers are the indices of
  /// the bodies.
  const std::uint64_t* numbers = nullptr;
};

/// Applies the bath e^{Ot}, exact for any t [davidchack2009]. With c = e^{−γt} and normal deviates
/// ξ, p ← c p + √((1 − c²) m kT) ξ. In the body frame L_k ← c L_k + √((1 − c²) J_k kT) ξ_k. This
/// flow conserves the Maxwell distribution of momenta. Axes with J_k = 0 have no momentum. If the
/// total momentum is held at 0, the net momentum of the noise is removed. Zero friction leaves
/// momenta unchanged, bit for bit.
/// @param stream  stream of random numbers, see stream_of()
/// @return  the kinetic energy that the bath gives to the bodies [kJ/mol]
double ornstein_uhlenbeck(State& state, const Bodies& bodies, const LangevinSettings& settings,
                          double t, std::uint64_t stream, Workers& workers = Workers::serial());

/// Applies the bath to translation and rotation with a given damping factor c instead of e^{−γt}; c
/// = 0 draws new momenta.
double refresh_momenta(State& state, const Bodies& bodies, const LangevinSettings& settings,
                       double c, std::uint64_t stream, Workers& workers = Workers::serial());

}  // namespace polhode
