// SPDX-License-Identifier: MIT
#include "polhode/measure/squared_force.hpp"

namespace polhode {

ByMotion<double> squared_force(const State& state, const Bodies& bodies, const Load& load) {
  ByMotion<double> sum{};
  for (std::size_t i = 0; i < state.size(); ++i) {
    const Vec3<double> tau = to_body(state.orientation[i], load.tau[i]);
    sum[0] += bodies.inverse_m[i] * norm2(load.f[i]);
    for (std::size_t k = 0; k < 3; ++k) sum[1 + k] += bodies.inverse_J[i][k] * tau[k] * tau[k];
  }
  return sum;
}

}  // namespace polhode
