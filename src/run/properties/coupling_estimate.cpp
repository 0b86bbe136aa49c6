// SPDX-License-Identifier: MIT
// Free energies from the stages of a coupling.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "io/settings/quantity.hpp"
#include "measure/equilibration.hpp"
#include "polhode/base/units.hpp"
#include "polhode/model/degrees_of_freedom.hpp"
#include "run/properties/dynamics.hpp"
#include "run/properties/estimates.hpp"
#include "run/properties/property.hpp"
#include "run/properties/second_virial.hpp"

namespace polhode {
namespace {

enum SumOf : std::size_t { before, after, volume_of_stage };

/// What a stage contributes to the free energy [kT], from the means of its sums. With the estimates
/// of the path, the contributions of all stages add up to it. The volumes make it the potential
/// relative to an ideal gas of the density of the whole system: without the molecule, the mean
/// volume is the inverse of the mean inverse volume of the first stage.
double part_of(Means means, std::size_t stage, std::size_t stages) {
  const bool first = stage == 0, last = stage + 1 == stages;
  return (first ? 0 : std::log(means[before])) - (last ? 0 : std::log(means[after])) +
         (first || last ? std::log(means[volume_of_stage]) : 0);
}

/// The sums of all stages as one block.
BlockMeans::Block joined(const std::vector<StageSegment>& segment) {
  BlockMeans::Block all{segment.front().sums.weight, {}};
  for (const StageSegment& stage : segment)
    all.sum.insert(all.sum.end(), stage.sums.sum.begin(), stage.sums.sum.end());
  return all;
}

/// The segments of a coupling in equilibrium: those from which on the free energy of all stages is
/// stationary.
std::span<const std::vector<StageSegment>> coupling_in_equilibrium(const Contribution& c) {
  const std::span<const std::vector<StageSegment>> segments = c.replica->coupled.segments;
  if (segments.empty()) return {};
  const std::size_t stages = segments.front().size();
  std::vector<BlockMeans::Block> blocks;
  for (const auto& segment : segments) blocks.push_back(joined(segment));
  const std::vector<double> mean = BlockMeans(blocks).mean();
  std::vector<double> series;
  for (const BlockMeans::Block& block : blocks) {
    double sum = 0;
    for (std::size_t k = 0; k < stages; ++k) {
      const std::size_t first = k * coupling_sums;
      if (k > 0) sum += block.sum[first + before] / (block.weight * mean[first + before]);
      if (k + 1 < stages) sum -= block.sum[first + after] / (block.weight * mean[first + after]);
    }
    series.push_back(sum);
  }
  return segments.subspan(equilibrium_start(series));
}

/// The time-step bias of the free energy [kT]. The stages are independent runs.
SeriesEstimate bias_of(const Contributions& contributions, std::size_t stages, FixedMeans fixed,
                       double degrees_of_freedom) {
  SeriesEstimate sum{0, 0, Known::yes, 0};
  for (std::size_t k = 0; k < stages; ++k) {
    const auto response_of = [&](const std::vector<StageSegment>& segment) -> const StepResponse& {
      return segment[k].response;
    };
    const SeriesEstimate one = step_bias(
        responses_of(contributions, coupling_in_equilibrium, response_of), degrees_of_freedom,
        fixed, [&](Means means) { return part_of(means, k, stages); });
    if (one.known != Known::yes) return one;
    sum.value += one.value;
    sum.error = std::hypot(sum.error, one.error);
    sum.modes += one.modes;
  }
  return sum;
}

/// The smallest overlap of neighbouring stages, from 0 to 1.
double smallest_overlap(Means means, std::size_t stages) {
  double smallest = 1;
  for (std::size_t k = 0; k + 1 < stages; ++k)
    smallest = std::min({smallest, 2 * means[k * coupling_sums + after],
                         2 * means[(k + 1) * coupling_sums + before]});
  return smallest;
}

/// A vapour in equilibrium with a liquid.
struct Vapour {
  double density = 0;   ///< number density [1/nm³]
  double pressure = 0;  ///< [kJ/mol/nm³]
};

/// The vapour with the chemical potential of a liquid. The liquid counts as incompressible between
/// its pressure and that of the vapour.
/// @param residual  residual chemical potential of the liquid [kT]
/// @param liquid    number density of the liquid [1/nm³]
/// @param B         second virial coefficient [nm³]
/// @return  not finite, or of too high a density, where the virial expansion ends
Vapour vapour_of(double residual, double liquid, double pressure, double kT, double B) {
  constexpr int iterations = 50;
  Vapour vapour{liquid * std::exp(residual), 0};
  for (int k = 0; k < iterations; ++k) {
    vapour.pressure = vapour.density * kT * (1 + B * vapour.density);
    const double compressed = (vapour.pressure - pressure) / (liquid * kT);
    vapour.density = liquid * std::exp(residual + compressed - 2 * B * vapour.density);
  }
  return vapour;
}

/// The residual chemical potential [kT].
double residual_of(Means means, const CouplingPath& path) {
  double sum = 0;
  for (std::size_t k = 0; k < path.size(); ++k)
    sum += path[k].next + part_of(means.subspan(k * coupling_sums, coupling_sums), k, path.size());
  return sum;
}

/// Replaces the residual chemical potential by the pressure of the vapour.
/// @param volume  mean volume of the liquid [nm³]
void to_vapour(MeasuredProperty& m, const PointData& data, double volume) {
  constexpr double max_density = 0.1;  // |B ρ|: terms of (B ρ)² are then below 1 %
  const double kT = units::boltzmann * data.at.temperature, bar = unit("bar", Dimension::pressure),
               liquid = static_cast<double>(data.topology.size()) / volume;
  const Molecule& molecule = data.topology.parts.front().molecule;
  const Estimate B = data.second_virial ? data.second_virial()
                                        : second_virial(molecule, data.mixing, data.at.temperature);
  if (!std::isfinite(B.value)) {
    m.value = {std::nan("")};
    m.obstacle = "the second virial coefficient was not completed";
    return;
  }
  const auto vapour = [&](double coefficient) {
    return vapour_of(m.value.value / kT, liquid, data.at.pressure, kT, coefficient);
  };
  const Vapour found = vapour(B.value);
  if (!(std::abs(B.value * found.density) < max_density)) {
    m.obstacle =
        "the vapour is too dense for its second virial coefficient; give a lower temperature";
    m.longer_helps = false;
  }
  const double per_potential = found.pressure / kT / bar,  // dp/dμ of a dilute vapour
      of_B = (vapour(B.value + B.error).pressure - found.pressure) / bar;
  if (m.bias) m.bias = scaled(*m.bias, per_potential);
  if (m.value.known == Known::yes) m.value.error = std::hypot(m.value.error * per_potential, of_B);
  m.value.value = found.pressure / bar;
}

}  // namespace

void estimate_coupling(MeasuredProperty& m, const Contributions& contributions,
                       const PointData& data) {
  constexpr double min_overlap = 0.03;
  if (contributions.all.empty()) return;
  const std::vector<BlockMeans> runs =
      separate_or_joined(runs_of(contributions, coupling_in_equilibrium, joined));
  if (runs.front().empty()) return;
  const CouplingPath& path = contributions.all.front().replica->coupled.path;
  if (std::ranges::any_of(contributions.all,
                          [&](const Contribution& c) { return c.replica->coupled.path != path; })) {
    m.obstacle =
        "replicas have different stages, because their shards had pilots of their own; give all "
        "shards the record of one pilot before they start";
    m.longer_helps = false;
    return;
  }
  const std::size_t stages = path.size();
  const double kT = units::boltzmann * data.at.temperature;
  m.value = pooled_estimate(runs, [&](Means all) { return kT * residual_of(all, path); });
  const std::vector<double> means = overall(runs);
  const double smallest = smallest_overlap(means, stages);
  m.remark = fmt::format("{} stages, smallest overlap {:.2f}", stages, smallest);
  if (!(smallest >= min_overlap))
    m.obstacle =
        fmt::format("the overlap of two stages, {:.2g}, is below {:g}", smallest, min_overlap);
  const double motions = degrees_of_freedom(data.topology).all();
  subtract_bias(m, scaled(bias_of(contributions, stages, data.fixed_means(), motions), kT));
  if (std::string_view(m.request.property->name) == "vapour-pressure")
    to_vapour(m, data, means.back());
}

}  // namespace polhode
