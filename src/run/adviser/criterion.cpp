// SPDX-License-Identifier: MIT
#include "polhode/run/adviser/criterion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/prediction.hpp"
#include "polhode/base/error.hpp"
#include "polhode/base/units.hpp"
#include "run/simulation/report/warning_rules.hpp"

namespace polhode {
namespace {

void check_bias_known(const EnsembleSettings& ensemble) {
  if (fixed_means(ensemble)) return;
  if (ensemble.hybrid_monte_carlo)
    throw Error(
        "hybrid Monte Carlo has no time-step bias, so a bias cannot be bounded; bound R (\"0.5 "
        "%\"), or choose the step and the trajectory length with --ensemble nvt");
  throw Error(
      "the time-step bias is not known in this ensemble; use constant energy, or type = "
      "\"rescaling\" in [thermostat] with edges = [\"xyz\"] in a [barostat], or bound R (\"0.5 "
      "%\")");
}

/// A confidence bound on the magnitude of a mean, for values that also have a common error.
double bound_with_common_error(const std::vector<double>& values,
                               const std::vector<double>& errors) {
  constexpr double factor = 2;  // number of standard errors for the probability of the bound
  const double size = std::abs(mean(values).value), common = factor * mean(errors).value;
  return size + std::hypot(size_bound(values, guarantee_probability) - size, common);
}

}  // namespace

Outcome outcome(const System& system, const Trajectory& trajectory) {
  Outcome run;
  run.failure = trajectory.failure;
  if (!run.failure.empty()) return run;
  const EnergyStatistics& energies = trajectory.statistics.energies;
  run.ratio = energies.ratio();
  run.drift = energies.drift().rate.value / static_cast<double>(system.topology.size());
  run.temperatures = energies.temperatures(degrees_of_freedom(system.topology));
  const Temperatures& T = run.temperatures;
  const ByMotion<double> kinds{T.translation, T.rotation[0], T.rotation[1], T.rotation[2]};
  for (std::size_t k = 0; k < kinds.size(); ++k)
    if (kinds[k] > 0) run.bias[k] = kinds[k] / T.all - 1;
  const StepBias bias =
      trajectory.statistics.step_bias.bias(degrees_of_freedom(system.topology), FixedMeans::energy);
  run.temperature_difference = bias.difference.value;
  run.translation_bias = degrees_of_freedom(system.topology).translation * units::boltzmann / 2 *
                         bias.translation.value;
  run.energy_bias = bias.potential.value / static_cast<double>(system.topology.size());
  run.pressure_bias = bias.pressure.value;
  run.configurational = trajectory.statistics.configurational.values();
  return run;
}

Criterion criterion_of(const Requirement& requirement, const EnsembleSettings& ensemble) {
  if (requirement.of != RequiredOf::ratio) check_bias_known(ensemble);
  switch (requirement.of) {
    case RequiredOf::ratio:
      return {Quality::ratio, requirement.bound};
    case RequiredOf::temperature_difference:
      return {Quality::temperature_difference, requirement.bound};
    case RequiredOf::energy:
      return {Quality::energy_bias, requirement.bound};
    case RequiredOf::pressure:
      return {Quality::pressure_bias, requirement.bound};
    case RequiredOf::density:
      break;
  }
  if (!ensemble.barostat)
    throw Error(
        "a bound on the bias of the density (\"density 0.02 %\") needs the compressibility in "
        "[barostat]; add the compressibility, or bound the bias of the pressure (\"pressure 4 "
        "bar\")");
  return {Quality::pressure_bias, requirement.bound / ensemble.barostat->compressibility};
}

void check_criterion(const Criterion& criterion, const Topology& topology) {
  const DegreesOfFreedom n = degrees_of_freedom(topology);
  if (criterion.quality == Quality::temperature_difference && n.all() == n.translation)
    throw Error(
        "no molecule rotates, so there is no difference between the temperatures of rotation and "
        "translation; bound the bias of the energy (\"energy 0.01 kJ/mol\") or R (\"0.5 %\")");
}

bool blew_up(const std::vector<Outcome>& runs) {
  return std::any_of(runs.begin(), runs.end(), [](auto& run) { return !run.failure.empty(); });
}

bool drifts(const std::vector<Outcome>& runs, double significance_level) {
  const auto rates = each(runs, &Outcome::drift);
  return drift_of_series(rates).p_value < significance_level;
}

double optimistic_bound(const std::vector<Outcome>& runs, double part) {
  if (blew_up(runs)) return std::numeric_limits<double>::infinity();
  std::vector<double> logs = each(runs, [](const Outcome& run) { return std::log(run.ratio); });
  const double middle = mean(logs).value;
  for (double& log : logs) log = middle + std::sqrt(part) * (log - middle);
  return std::exp(prediction_bound(logs, guarantee_probability));
}

bool may_meet(const Criterion& criterion, const std::vector<Outcome>& runs, double part) {
  if (blew_up(runs)) return false;
  return criterion.quality != Quality::ratio || optimistic_bound(runs, part) <= criterion.bound;
}

double upper_bound(Quality quality, const std::vector<Outcome>& runs) {
  if (blew_up(runs)) return std::numeric_limits<double>::infinity();
  const auto size = [&](double Outcome::*member, double Outcome::*common = nullptr) {
    return common ? bound_with_common_error(each(runs, member), each(runs, common))
                  : size_bound(each(runs, member), guarantee_probability);
  };
  switch (quality) {
    case Quality::ratio:
      return optimistic_bound(runs, 1);
    case Quality::drift:
      return size(&Outcome::drift);
    case Quality::temperature_difference:
      return size(&Outcome::temperature_difference);
    case Quality::energy_bias:
      return size(&Outcome::energy_bias, &Outcome::energy_bias_error);
    case Quality::pressure_bias:
      return size(&Outcome::pressure_bias, &Outcome::pressure_bias_error);
    case Quality::temperature_bias: {
      const auto biases = [&](std::size_t k) {
        return each(runs, [k](const Outcome& run) { return run.bias[k]; });
      };
      const auto alive = [&](std::size_t k) { return biases(k)[0] != 0; };
      const std::array<std::size_t, 4> kinds{0, 1, 2, 3};
      const auto share = static_cast<double>(std::count_if(kinds.begin(), kinds.end(), alive));
      double largest = 0;
      for (const std::size_t k : kinds)
        if (alive(k))
          largest =
              std::max(largest, size_bound(biases(k), 1 - (1 - guarantee_probability) / share));
      return largest;
    }
  }
  return 0;
}

double upper_bound(const Criterion& criterion, const std::vector<Outcome>& runs) {
  const double bound = upper_bound(criterion.quality, runs);
  constexpr std::array predicted{Quality::temperature_difference, Quality::energy_bias,
                                 Quality::pressure_bias};
  if (std::ranges::find(predicted, criterion.quality) == predicted.end()) return bound;
  return std::max(bound, criterion.bound * upper_bound(Quality::ratio, runs) / max_ratio);
}

Estimate AdviserPoint::ratio() const { return mean(each(runs, &Outcome::ratio)); }

Estimate AdviserPoint::drift() const { return mean(each(runs, &Outcome::drift)); }

Estimate AdviserPoint::bias(std::size_t kind) const {
  return mean(each(runs, [kind](const Outcome& run) { return run.bias[kind]; }));
}

double AdviserPoint::max_rounding() const {
  return std::ranges::max(each(runs, &Outcome::rounding));
}

}  // namespace polhode
