// SPDX-License-Identifier: MIT
#include "polhode/measure/shadow.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "polhode/measure/squared_force.hpp"

namespace polhode {

ErrorBrackets error_brackets(const State& state, const Bodies& bodies, const Load& load,
                             ForceField& forces) {
  Vec3Column v(state.size()), omega(state.size());  // omega in the body frame
  for (std::size_t i = 0; i < state.size(); ++i) {
    v.set(i, bodies.inverse_m[i] * state.p[i]);
    omega.set(i, scaled(bodies.inverse_J[i], to_body(state.orientation[i], state.ell[i])));
  }
  Load slope;
  forces.directional_derivative(state, v, omega, slope);
  const ByMotion<double> squares = squared_force(state, bodies, load);
  ErrorBrackets brackets{0, std::accumulate(squares.begin(), squares.end(), 0.0)};
  for (std::size_t i = 0; i < state.size(); ++i) {
    const Quaternion<double> a = state.orientation[i];
    const Vec3<double> acceleration =  // acceleration of a free body: J⁻¹ (L × ω)
        scaled(bodies.inverse_J[i], cross(to_body(a, state.ell[i]), omega[i]));
    brackets.second_derivative -= dot(v[i], slope.f[i]) + dot(omega[i], to_body(a, slope.tau[i])) +
                                  dot(acceleration, to_body(a, load.tau[i]));
  }
  return brackets;
}

void ShadowStatistics::add(double time, double shadow) {
  if (samples++ == 0) first = shadow, start = time;
  const double x = shadow - first;
  blocks.add(std::array{time - start, x, x * x});
}

SeriesEstimate ShadowStatistics::fluctuation() const {
  return series_estimate(blocks.means(), [](auto mean) {
    return std::sqrt(std::max(0.0, mean[2] - mean[1] * mean[1]));
  });
}

Drift ShadowStatistics::drift() const { return series_drift_over_walk(blocks.means(), 0, 1); }

std::vector<WalkStrength> ShadowStatistics::walks() const {
  return walk_strengths(blocks.means(), 0, 1);
}

std::optional<ShadowSummary> shadow_summary(const ShadowStatistics& statistics, const Drift& raw) {
  if (statistics.samples < 3) return std::nullopt;
  ShadowSummary s{statistics.samples, statistics.fluctuation(), statistics.drift(), std::nullopt};
  if (raw.known == Known::yes && s.drift.known == Known::yes && s.drift.rate.error > 0)
    s.time_gain = std::pow(raw.rate.error / s.drift.rate.error, 2.0 / 3);
  return s;
}

}  // namespace polhode
