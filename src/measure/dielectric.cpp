// SPDX-License-Identifier: MIT
#include "measure/dielectric.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "model/dipole.hpp"
#include "polhode/base/units.hpp"

namespace polhode {
namespace {

enum Mean : std::size_t { Mx, My, Mz, M2, volume, kinetic };

double variance(std::span<const double> mean) {
  return mean[M2] - norm2(Vec3<double>{mean[Mx], mean[My], mean[Mz]});
}

// The dielectric constant ε from the means of M, M² and V. The result is not positive if the
// fluctuations are too large for any ε.
double permittivity(std::span<const double> mean, double temperature,
                    double surroundings_permittivity) {
  // The factor 1/ε₀ is 4π times Coulomb's constant.
  const double g = 4 * units::pi * units::coulomb * variance(mean) /
                   (3 * mean[volume] * units::boltzmann * temperature);
  if (std::isinf(surroundings_permittivity)) return 1 + g;
  return (1 + 2 * surroundings_permittivity * (1 + g)) / (1 + 2 * surroundings_permittivity - g);
}

double mean_over_rms(const BlockMeans& means) {
  const std::vector<double> mean = means.mean();
  return norm(Vec3<double>{mean[Mx], mean[My], mean[Mz]}) / std::sqrt(mean[M2]);
}

/// Replaces the error of a result by "run too short" if ⟨M⟩² is larger than in a sufficiently long
/// run.
SeriesEstimate at_rest(const BlockMeans& means, const SeriesEstimate& e) {
  constexpr double limit = 0.1;  // largest ⟨M⟩², relative to ⟨M²⟩
  const double share = mean_over_rms(means);
  return e.known == Known::yes && share * share > limit
             ? SeriesEstimate{e.value, 0, Known::too_short}
             : e;
}

}  // namespace

Vec3<double> total_dipole(const State& state, const Topology& topology) {
  Vec3<double> M{};
  std::size_t i = 0;
  for (const auto& [molecule, count] : topology.parts) {
    const Vec3<double> dipole = dipole_moment(molecule);
    for (const std::size_t end = i + count; i < end; ++i) M += to_lab(state.orientation[i], dipole);
  }
  return M;
}

TotalDipole::TotalDipole(const Topology& topology) : topology_(topology) {
  for (const auto& [molecule, count] : topology.parts)
    squares_ += static_cast<double>(count) * norm2(dipole_moment(molecule));
}

void TotalDipole::add(const State& state, const std::optional<StepError>& error) {
  const Vec3<double> M = total_dipole(state, topology_);
  const double V = state.box.volume();
  blocks_.add(std::array{M.x, M.y, M.z, norm2(M), V});
  if (error) response_.add(*error, std::array{M.x, M.y, M.z, norm2(M), V, error->kinetic});
}

TotalDipole::Result TotalDipole::result(double temperature, double surroundings_permittivity,
                                        double interval) const {
  const BlockMeans means = blocks_.means();
  const auto epsilon = [&](std::span<const double> mean) {
    return permittivity(mean, temperature, surroundings_permittivity);
  };
  Result result;
  result.constant = at_rest(means, series_estimate(means, epsilon));
  result.kirkwood =
      at_rest(means, series_estimate(means, [&](auto mean) { return variance(mean) / squares_; }));
  result.mean_over_rms = mean_over_rms(means);
  const bool timed = interval > 0;
  const double length = means.empty() ? 0 : means.sum().weight * (timed ? interval : 1);
  const Obstacle obstacle = result.constant.known != Known::yes             ? Obstacle::no_error
                            : still_moving(means, result.constant, epsilon) ? Obstacle::still_moving
                                                                            : Obstacle::none;
  result.convergence = convergence(length, relaxation_share(means, Mx, M2) * length,
                                   relaxations_of_dipole, obstacle);
  // In a short run the relaxation time is uncertain, too.
  if (obstacle != Obstacle::none)
    result.convergence.needed = std::max(result.convergence.needed, 2 * length);
  if (!timed) result.convergence.unit = "frames";
  std::vector<BlockMeans::Block> first;
  double frames = 0;
  for (const BlockMeans::Block& block : means.blocks()) {
    first.push_back(block);
    const BlockMeans so_far(first);
    result.stages.push_back(at_rest(so_far, series_estimate(so_far, epsilon)));
    result.frames.push_back(frames += block.weight);
  }
  return result;
}

TotalDipole::StepBias TotalDipole::step_bias(std::optional<double> given, double surroundings,
                                             double degrees_of_freedom, FixedMeans fixed) const {
  const auto of = [&](const StepResponse::Function& f) {
    return response_.bias(degrees_of_freedom, fixed, f);
  };
  return {of([&](std::span<const double> mean) {
            const double T =
                given.value_or(polhode::temperature(mean[kinetic], degrees_of_freedom));
            return permittivity(mean, T, surroundings);
          }),
          of([&](std::span<const double> mean) { return variance(mean) / squares_; })};
}

}  // namespace polhode
