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
  double kT = 0;                   ///< [kJ/mol]
  double friction = 0;             ///< γ of p [1/ps]
  double rotational_friction = 0;  ///< γ of L [1/ps]
  std::uint64_t seed = 0;
  TotalMomentum total_momentum = TotalMomentum::held;
  /// The number of each body, padded as a Column. It selects the random numbers, which therefore do
  /// not depend on the place of a body in its column. Null: the indices of the bodies.
  const std::uint64_t* numbers = nullptr;
};

/// The bath e^{Ot}, exact for any t [davidchack2009]. With c = e^{−γt} and normal deviates ξ, p ← c
/// p + √((1 − c²) m kT) ξ. In the body frame L_k ← c L_k + √((1 − c²) J_k kT) ξ_k. It conserves the
/// Maxwell distribution. Axes with J_k = 0 have no momentum. If the total momentum is held, the
/// momentum of the noise is removed. Zero friction leaves momenta unchanged, bit for bit.
/// @param stream  of random numbers, see stream_of()
/// @return  the kinetic energy that the bath gives to the bodies [kJ/mol]
double ornstein_uhlenbeck(State& state, const Bodies& bodies, const LangevinSettings& settings,
                          double t, std::uint64_t stream, Workers& workers = Workers::serial());

/// Applies the bath with a given c instead of e^{−γt}, for both motions; 0 draws new momenta.
double refresh_momenta(State& state, const Bodies& bodies, const LangevinSettings& settings,
                       double c, std::uint64_t stream, Workers& workers = Workers::serial());

}  // namespace polhode
