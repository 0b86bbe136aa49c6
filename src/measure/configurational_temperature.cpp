// SPDX-License-Identifier: MIT
#include "polhode/measure/configurational_temperature.hpp"

#include <cmath>

#include "polhode/base/units.hpp"

namespace polhode {
namespace {

Vec3<double> signs(Random& random) {
  const std::uint64_t bits = random.bits();
  const auto sign = [&](int k) { return (bits >> k & 1) != 0 ? 1.0 : -1.0; };
  return {sign(0), sign(1), sign(2)};
}

}  // namespace

ConfigurationalSample configurational_sample(const State& state, const Bodies& bodies,
                                             const Load& load, ForceField& forces, Random random) {
  // The displacement of each degree of freedom is scaled by its inertia: by 1/√m for translation,
  // and by 1/√J_k for rotation about an axis.
  Vec3Column dq(state.size()), dtheta(state.size());
  for (std::size_t i = 0; i < state.size(); ++i) {
    const auto root = [](double x) { return std::sqrt(x); };
    const Vec3<double> inverse_J = bodies.inverse_J[i];
    dq.set(i, root(bodies.inverse_m[i]) * signs(random));
    dtheta.set(i, scaled(signs(random), {root(inverse_J.x), root(inverse_J.y), root(inverse_J.z)}));
  }
  Load slope;
  forces.directional_derivative(state, dq, dtheta, slope);
  ConfigurationalSample sample{squared_force(state, bodies, load), {}};
  for (std::size_t i = 0; i < state.size(); ++i) {
    // A rotation about an axis leaves this axis unchanged, so the curvature has no term from the
    // rotation of the frame.
    const Vec3<double> tau = to_body(state.orientation[i], slope.tau[i]);
    sample.curvature[0] -= dot(dq[i], slope.f[i]);
    for (std::size_t k = 0; k < 3; ++k) sample.curvature[1 + k] -= dtheta[i][k] * tau[k];
  }
  return sample;
}

namespace {
constexpr std::size_t motions = std::tuple_size_v<ByMotion<double>>;

/// The temperature of one motion (translation, or rotation about an axis) [K], from the mean
/// squared force and the mean curvature.
StepResponse::Function temperature_of(std::size_t motion) {
  return [motion](std::span<const double> mean) {
    return mean[motion] / (units::boltzmann * mean[motions + motion]);
  };
}

/// Applies a function to each motion on which forces act. Motions without forces have no curvature.
template <class Of>
ByMotion<std::optional<SeriesEstimate>> of_motions(const TimeBlocks& blocks, const Of& of) {
  const std::vector<double> mean = blocks.means().mean();
  ByMotion<std::optional<SeriesEstimate>> all;
  for (std::size_t k = 0; k < motions && !mean.empty(); ++k)
    if (mean[motions + k] != 0) all[k] = of(temperature_of(k));
  return all;
}
}  // namespace

void ConfigurationalStatistics::add(const ConfigurationalSample& sample,
                                    const std::optional<StepError>& error) {
  std::array<double, 2 * motions> both;
  for (std::size_t k = 0; k < motions; ++k)
    both[k] = sample.squared_force[k], both[motions + k] = sample.curvature[k];
  blocks.add(both);
  if (error) response.add(*error, both);
}

ByMotion<std::optional<SeriesEstimate>> ConfigurationalStatistics::temperatures() const {
  const BlockMeans means = blocks.means();
  return of_motions(blocks, [&](const auto& T) { return series_estimate(means, T); });
}

ByMotion<std::optional<SeriesEstimate>> ConfigurationalStatistics::step_bias(
    double degrees_of_freedom, FixedMeans fixed) const {
  if (response.blocks.blocks.empty()) return {};
  return of_motions(blocks,
                    [&](const auto& T) { return response.bias(degrees_of_freedom, fixed, T); });
}

std::optional<ByMotion<double>> ConfigurationalStatistics::values() const {
  if (blocks.blocks.empty()) return std::nullopt;
  const auto known = temperatures();
  ByMotion<double> values;
  for (std::size_t k = 0; k < motions; ++k) values[k] = known[k].value_or(SeriesEstimate{}).value;
  return values;
}

}  // namespace polhode
