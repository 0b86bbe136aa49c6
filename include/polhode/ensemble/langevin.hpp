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
  /// Of each body, which selects its random numbers, so that they do not depend on the position of
  /// a body in its column; padded as a Column. Null: the indices of the bodies.
  const std::uint64_t* numbers = nullptr;
};

/// e^{Ot}, exact for any t [davidchack2009]: with c = e^{−γt} and normal deviates ξ, p ← c p +
/// √((1 − c²) m kT) ξ, and in the body frame L_k ← c L_k + √((1 − c²) J_k kT) ξ_k. It keeps the
/// Maxwell distribution. Axes with J_k = 0 have no momentum and get none. Where the total momentum
/// is held, that of the noise is removed. Zero friction leaves momenta as they are, to the bit.
/// @param stream  of random numbers, see stream_of()
/// @return  the kinetic energy that the bath gives to the bodies [kJ/mol]
double ornstein_uhlenbeck(State& state, const Bodies& bodies, const LangevinSettings& settings,
                          double t, std::uint64_t stream, Workers& workers = Workers::serial());

/// The same with c given in place of e^{−γt}, for both motions: 0 draws new ones.
double refresh_momenta(State& state, const Bodies& bodies, const LangevinSettings& settings,
                       double c, std::uint64_t stream, Workers& workers = Workers::serial());

}  // namespace polhode
