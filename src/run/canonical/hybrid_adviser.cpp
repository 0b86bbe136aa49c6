// SPDX-License-Identifier: MIT
#include "run/canonical/hybrid_adviser.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <span>
#include <utility>

#include "io/files/with_error.hpp"
#include "io/settings/output_units.hpp"
#include "io/settings/scheme_labels.hpp"
#include "measure/autocorrelation_time.hpp"
#include "polhode/ensemble/hybrid_monte_carlo.hpp"
#include "polhode/io/settings/nested_scheme_text.hpp"
#include "polhode/math/random.hpp"
#include "polhode/run/simulation/trajectory/trajectory.hpp"
#include "polhode/run/study/study.hpp"
#include "run/quantity_lists.hpp"
#include "run/simulation/system/stable_step.hpp"

namespace polhode {
namespace {

// The grid of steps and of numbers of steps per trajectory. The unit of steps is the number of
// force evaluations per step divided by the Einstein frequency. Steps range from the adviser's
// first step at constant energy to steps at which liquids blow up.
constexpr std::array<double, 6> step_parts = {0.12, 0.17, 0.24, 0.34, 0.48, 0.68};
constexpr std::array<std::size_t, 4> step_counts = {4, 8, 16, 32};
constexpr double discarded = 0.2;  // fraction of each run that is discarded at its beginning

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

/// The results of a run.
struct HybridRun {
  double acceptance = no_value, weight = no_value;
  std::vector<double> potential{};  // potential energy at the ends of trajectories; empty if the
                                    // run blew up
};

/// The mean over runs; NaN unless the value is known for all runs.
Estimate mean_over(const std::vector<HybridRun>& runs, double HybridRun::*value) {
  std::vector<double> values;
  for (const HybridRun& run : runs) values.push_back(run.*value);
  return mean(values);
}

/// The autocorrelation time of U at the ends of trajectories, from all runs together; empty if the
/// runs are too short.
std::optional<AutocorrelationTime> autocorrelation_time(const std::vector<HybridRun>& runs) {
  std::vector<std::span<const double>> counted;
  for (const HybridRun& run : runs) {
    const auto n = static_cast<double>(run.potential.size());
    counted.push_back(std::span(run.potential).subspan(static_cast<std::size_t>(discarded * n)));
  }
  return polhode::autocorrelation_time(counted);
}

/// Sorts choices by the cost of a sample, and removes choices with an unknown cost.
void sort_by_cost(std::vector<HybridChoice>& choices) {
  std::erase_if(choices, [](const auto& choice) { return !choice.evaluations_per_sample; });
  std::sort(choices.begin(), choices.end(), [](const auto& a, const auto& b) {
    return a.evaluations_per_sample->value < b.evaluations_per_sample->value;
  });
}

class HybridAdviser {
 public:
  HybridAdviser(const Config& config, const HybridAdviserSettings& settings,
                const Callbacks& callbacks, Workers& workers)
      : config_(config),
        settings_(settings),
        callbacks_(callbacks),
        workers_(workers),
        scheme_(single_scheme_of(settings.scheme)) {
    check_hybrid(scheme_);
  }

  HybridAdvice advise() {
    HybridAdvice advice{
        .scheme = label_of(settings_.scheme), .pilots = {}, .finalists = {}, .equal = {}};
    const System base = build_system(config_);
    prepare(base);
    if (callbacks_.stopped()) {
      advice.stopped = true;
      return advice;
    }
    const double unit = scheme_.cost() / einstein_frequency(base, starts_[0].state, workers_);
    for (const double part : step_parts)
      for (const std::size_t steps : step_counts)
        advice.pilots.push_back({.step = part * unit, .steps = steps});
    measure(advice.pilots, settings_.evaluations, 0);
    advice.finalists = best_of(advice.pilots);
    measure(advice.finalists, settings_.longer * settings_.evaluations, 1);
    rank(advice);
    advice.stopped = callbacks_.stopped();
    return advice;
  }

 private:
  void prepare(const System& base) {
    starts_.assign(static_cast<std::size_t>(settings_.runs), base);
    const double length = std::min(config_.study.decorrelate, 2.0);
    workers_.each(starts_.size(), [&](std::size_t r) {
      starts_[r] = prepare_start(base, config_, r, length, callbacks_.stop);
    });
  }

  std::vector<HybridChoice> best_of(std::vector<HybridChoice> choices) const {
    sort_by_cost(choices);
    choices.resize(std::min(choices.size(), settings_.finalists));
    return choices;
  }

  /// Runs all choices of hybrid Monte Carlo settings from all initial configurations.
  /// @param round  number of the round; each round has different random numbers
  void measure(std::vector<HybridChoice>& choices, std::size_t evaluations, std::uint64_t round) {
    std::vector<std::vector<HybridRun>> runs(choices.size(),
                                             std::vector<HybridRun>(starts_.size()));
    workers_.each(choices.size() * starts_.size(), [&](std::size_t k) {
      if (callbacks_.stopped()) return;
      const std::size_t choice = k / starts_.size(), start = k % starts_.size();
      const std::uint64_t seed = derived_seed(start_seed(config_, start), 2 * choice + round);
      runs[choice][start] = run(choices[choice], starts_[start], evaluations, seed);
      report(static_cast<double>(evaluations));
    });
    for (std::size_t k = 0; k < choices.size(); ++k) {
      choices[k].acceptance = mean_over(runs[k], &HybridRun::acceptance);
      choices[k].weight = mean_over(runs[k], &HybridRun::weight);
      const double cost = 2 * evaluations_of(choices[k]);
      const auto tau = autocorrelation_time(runs[k]);
      choices[k].evaluations_per_sample =
          tau ? std::optional(Estimate{cost * tau->value, cost * tau->error}) : std::nullopt;
    }
  }

  /// The number of force evaluations of a trajectory.
  double evaluations_of(const HybridChoice& choice) const {
    return scheme_.cost() * static_cast<double>(choice.steps);
  }

  HybridRun run(const HybridChoice& choice, const System& start, std::size_t evaluations,
                std::uint64_t seed) const {
    System system = start;
    ForceField forces(system.topology, system.forces, system.state.box);
    const double trajectories =
        std::ceil(static_cast<double>(evaluations) / evaluations_of(choice));
    const double duration = choice.step * static_cast<double>(choice.steps);
    TrajectorySettings settings{.scheme = scheme_,
                                .step = choice.step,
                                .length = trajectories * duration,
                                .sample = duration,
                                .lambda = config_.integrator.lambda,
                                .seed = seed};
    settings.ensemble = {.temperature = config_.system.temperature,
                         .thermostat = {},
                         .barostat = {},
                         .hybrid_monte_carlo = HybridMonteCarloSettings{.steps = choice.steps}};
    std::vector<double> potential;
    const Trajectory t = run_trajectory(system, forces, settings,
                                        {[&](std::size_t, const State&, const Energies& now) {
                                           potential.push_back(now.potential());
                                         },
                                         callbacks_.stop});
    HybridRun result;
    const HybridMonteCarloMemory& hybrid = t.ensemble.hybrid;
    if (!t.failure.empty() || hybrid.trajectories == 0) return result;
    result.acceptance =
        static_cast<double>(hybrid.accepted) / static_cast<double>(hybrid.trajectories);
    result.weight = hybrid.weights.means().mean().at(0);
    result.potential = std::move(potential);
    return result;
  }

  void report(double evaluations) {
    const std::lock_guard lock(guard_);
    done_ += evaluations;
    const double grid = static_cast<double>(step_parts.size() * step_counts.size());
    const auto finals = static_cast<double>(settings_.finalists * settings_.longer);
    callbacks_.report(
        {"hybrid Monte Carlo",
         done_ / (static_cast<double>(settings_.evaluations * starts_.size()) * (grid + finals))});
  }

  const Config& config_;
  const HybridAdviserSettings& settings_;
  const Callbacks& callbacks_;
  Workers& workers_;
  Scheme scheme_;
  std::vector<System> starts_;
  std::mutex guard_;
  double done_ = 0;  // number of force evaluations done
};

std::string choice_text(const HybridChoice& choice) {
  return fmt::format("{} steps of {:.2g} fs", choice.steps, choice.step * units::fs_per_ps);
}

std::vector<Quantities> records_of(const std::vector<HybridChoice>& choices) {
  std::vector<Quantities> records;
  for (const HybridChoice& c : choices) {
    const bool stable = std::isfinite(c.weight.value);
    const auto known = [](const Estimate& e) {
      return std::isfinite(e.value) ? Value(nested(e)) : Value();
    };
    records.push_back(
        {{"step", "fs", c.step * units::fs_per_ps, "time step", "step"},
         {"steps", "", c.steps, "number of steps of a trajectory", "steps"},
         {"acceptance", "%", known(c.acceptance), "acceptance of proposals", "acceptance"},
         {"exp_dH", "", known(c.weight), "mean of exp(-dH/kT)", "<exp(-dH/kT)>"},
         {"force_evaluations_per_sample", "", nested(c.evaluations_per_sample),
          "force evaluations per independent sample of the potential energy U",
          "evaluations/sample"},
         row("remark", stable ? "" : "a run blew up")});
  }
  return records;
}

}  // namespace

void rank(HybridAdvice& advice) {
  auto& list = advice.finalists;
  sort_by_cost(list);
  advice.equal.clear();
  for (std::size_t k = 1; k < list.size(); ++k) {
    const Estimate &best = *list[0].evaluations_per_sample, &cost = *list[k].evaluations_per_sample;
    if (cost.value - best.value < 2 * std::hypot(cost.error, best.error)) advice.equal.push_back(k);
  }
}

HybridAdvice advise_hybrid(const Config& config, const HybridAdviserSettings& settings,
                           const Callbacks& callbacks, Workers& workers) {
  return HybridAdviser(config, settings, callbacks, workers).advise();
}

std::string answer(const HybridAdvice& advice) {
  if (advice.finalists.empty())
    return "all runs are too short to determine the autocorrelation time of the potential energy "
           "U; give a larger number of evaluations";
  const HybridChoice& best = advice.finalists.front();
  const Estimate& cost = *best.evaluations_per_sample;
  std::string text = fmt::format(
      "hybrid Monte Carlo with {}: {}, acceptance {:.0f} %, {} force evaluations per independent "
      "sample of the potential energy U",
      advice.scheme, choice_text(best), 100 * best.acceptance.value,
      with_error(cost.value, cost.error));
  for (const std::size_t k : advice.equal)
    text += fmt::format(
        "{}{}",
        k == advice.equal.front() ? "; not distinguishable in cost from this choice: " : ", ",
        choice_text(advice.finalists[k]));
  const bool longer_steps = std::any_of(advice.pilots.begin(), advice.pilots.end(),
                                        [&](const auto& c) { return c.step > best.step; });
  if (!longer_steps && !advice.pilots.empty())
    text += "; longer steps were not tried and may be cheaper";
  return text;
}

Quantities quantities(const HybridAdvice& advice) {
  Quantities list = {
      {"scheme", "", advice.scheme, "scheme of the proposals"},
      detail({"pilots", "", records_of(advice.pilots),
              "short runs of all combinations of time step and trajectory length", "pilot runs"}),
      detail({"finalists", "", records_of(advice.finalists),
              "longer runs of the best combinations; the first is the recommended combination",
              "independent, longer runs of the best combinations"}),
      {"not_distinguishable", "", advice.equal,
       "indices (from 0) of the finalists whose cost is not distinguishable from the lowest cost"},
      {"answer", "", answer(advice), "recommendation in words"}};
  if (!advice.finalists.empty()) list.push_back(row("", answer(advice)));
  return list;
}

}  // namespace polhode
