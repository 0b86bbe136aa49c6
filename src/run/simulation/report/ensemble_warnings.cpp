// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "polhode/ensemble/barostat.hpp"
#include "run/simulation/report/warning_rules.hpp"

namespace polhode {
namespace {

constexpr double min_volume_change = 0.005;  // smallest relevant change, relative to the mean
// Minimum number of relaxation times of the volume. With 20 relaxation times, the variance of the
// volume has a relative error √(2τ/T) of about a third.
constexpr double min_relaxation_times = 20;
constexpr std::uint64_t min_accepted_moves = 100;  // minimum for Monte Carlo moves
constexpr double min_acceptance = 0.5;             // minimum acceptance rate of cell rescaling, and
                                                   // of hybrid Monte Carlo
constexpr double min_move_acceptance = 0.1;        // minimum acceptance rate of Monte Carlo moves
                                                   // of the volume
constexpr double max_acceptance = 0.99;            // maximum acceptance rate of hybrid Monte Carlo
constexpr double min_weight_difference = 1e-3;

/// Three standard deviations of the acceptance rate over n moves, for a given acceptance
/// probability.
double chance(double probability, std::uint64_t n) {
  return far * std::sqrt(probability * (1 - probability) / static_cast<double>(n));
}

std::optional<Warning> volume_warning(const BarostatSummary& s, double length) {
  const Drift& slope = s.volume_drift;
  const double change = slope.rate.value * length, bound = min_volume_change * s.volume.value;
  const bool known = slope.known == Known::yes;
  if ((known && slope.p_value > significance_level) || !(std::abs(change) > bound))
    return std::nullopt;
  return Warning{"volume", change, bound,
                 fmt::format("the volume {} by {:.2g} % in this run (bound: {:g} %; {}), so "
                             "density and averages are not at equilibrium",
                             known ? "still drifts" : "changes from the beginning to the end",
                             100 * change / s.volume.value, 100 * min_volume_change,
                             known ? fmt::format("p-value {:.2g}", slope.p_value)
                                   : "the run is too short for an error estimate"),
                 "run longer, or start a new run from the final state of this run"};
}

/// Warns of a run that is too short for density and compressibility. The stated errors cannot
/// reveal a run that is too short, because they are computed from the same few fluctuations.
std::optional<Warning> length_warning(const BarostatSummary& s, const BarostatSettings& settings,
                                      double length) {
  const bool rescaling = std::holds_alternative<CellRescaling>(settings.type);
  const bool known = s.compressibility.known == Known::yes;
  const double relaxation = volume_relaxation(settings, known ? s.compressibility.value : 0);
  const double value = rescaling ? length / relaxation : static_cast<double>(s.accepted);
  const auto bound = rescaling ? min_relaxation_times : static_cast<double>(min_accepted_moves);
  if (s.moves == 0 || !(value < bound)) return std::nullopt;
  const std::string what =
      rescaling
          ? fmt::format("{:.3g} relaxation times of the volume ({:.3g} ps each)", value, relaxation)
          : fmt::format("{} accepted moves of the volume", s.accepted);
  return Warning{"volume_samples", value, bound,
                 fmt::format("the run has {} (bound: {:g}), too few for reliable errors: the true "
                             "errors of density and compressibility are larger than printed",
                             what, bound),
                 rescaling
                     ? "run longer, or use a shorter time_constant or a more accurate "
                       "compressibility in [barostat]"
                     : "run longer, or move the volume more often (smaller every in [barostat])"};
}

std::optional<Warning> moves_warning(const BarostatSummary& s, const BarostatSettings& settings) {
  const bool rescaling = std::holds_alternative<CellRescaling>(settings.type);
  const double bound = rescaling ? min_acceptance : min_move_acceptance;
  if (s.moves == 0 || !(s.acceptance() < bound - chance(bound, s.moves))) return std::nullopt;
  return Warning{"barostat", 100 * s.acceptance(), 100 * bound,
                 fmt::format("only {:.2g} % of the moves of the box were accepted (bound: {:g} %), "
                             "so the volume relaxes more slowly than intended",
                             100 * s.acceptance(), 100 * bound),
                 rescaling
                     ? "in [barostat] use a shorter interval (every), a longer time_constant or a "
                       "more accurate compressibility"
                     : "use a smaller compressibility in [barostat], so that moves are smaller"};
}

std::optional<Warning> shape_warning(const BarostatSummary& s) {
  if (s.beyond_shape == 0) return std::nullopt;
  return Warning{
      "shape", static_cast<double>(s.beyond_shape), 0,
      fmt::format("{} moves of the box were rejected because they would have changed the ratio of "
                  "two separately scaled edges by more than a factor of {:g}: the shape of the box "
                  "drifts, as in a fluid",
                  s.beyond_shape, max_shape_change),
      "for a fluid use edges = [\"xyz\"] in [barostat]; for a crystal start a new run from the "
      "final state, so that its shape becomes the reference"};
}

std::optional<Warning> acceptance_warning(const HybridMonteCarloSummary& s) {
  if (s.trajectories == 0) return std::nullopt;
  const double a = s.acceptance();
  const bool low = a < min_acceptance - chance(min_acceptance, s.trajectories);
  if (!low && !(a > max_acceptance + chance(max_acceptance, s.trajectories))) return std::nullopt;
  const double bound = low ? min_acceptance : max_acceptance;
  return Warning{
      "acceptance", 100 * a, 100 * bound,
      fmt::format("{:.3g} % of the trajectories of hybrid Monte Carlo were accepted, {} {:g} %: {}",
                  100 * a, low ? "below" : "above", 100 * bound,
                  low ? "most of the work is discarded" : "longer steps would cost less"),
      low ? "use a shorter step, or a scheme with a smaller error" : "use a longer step"};
}

/// Warns if the mean of exp(−ΔH/kT), or the bounded mean, deviates from the exact value. The error
/// of the mean of exp(−ΔH/kT) is unknown or large if a few large values dominate the mean.
std::optional<Warning> weight_warning(const HybridMonteCarloSummary& s) {
  const auto warning = [](const SeriesEstimate& mean, double exact,
                          const char* name) -> std::optional<Warning> {
    const double difference = mean.value - exact;
    const double bound = std::max(min_weight_difference, three_sigma(mean));
    if (mean.known != Known::yes || !(std::abs(difference) > bound)) return std::nullopt;
    return Warning{
        "weights", difference, bound,
        fmt::format("the mean of {} is {:.4g} ± {:.2g} instead of the canonical value {:g}, so "
                    "this run has not sampled the canonical distribution",
                    name, mean.value, mean.error, exact),
        "equilibrate longer before the run, or use a shorter step; external forces must depend "
        "only on positions, orientations and the box"};
  };
  const auto first = warning(s.weight, 1, "exp(-dH/kT)");
  return first ? first : warning(s.bounded_weight, 0, "(exp(-dH/kT) - 1) exp(-|dH|/kT)");
}

}  // namespace

double volume_relaxation(const BarostatSettings& barostat, double compressibility) {
  constexpr double moves = 4;  // largest Monte Carlo moves are two standard deviations of the
                               // volume
  const auto* const rescaling = std::get_if<CellRescaling>(&barostat.type);
  const double softer =
      barostat.compressibility > 0 ? compressibility / barostat.compressibility : 1;
  return std::max(1.0, softer) * (rescaling ? rescaling->time_constant : moves * barostat.every);
}

std::vector<Warning> ensemble_warnings(const RunSummary& s) {
  std::vector<Warning> all;
  if (const auto& barostat = s.ensemble.barostat) {
    const BarostatSettings& settings = s.ensemble.settings.barostat.value();
    append(all, {volume_warning(*barostat, s.length), length_warning(*barostat, settings, s.length),
                 moves_warning(*barostat, settings), shape_warning(*barostat)});
  }
  if (const auto& hybrid = s.ensemble.hybrid_monte_carlo)
    append(all, {acceptance_warning(*hybrid), weight_warning(*hybrid)});
  return all;
}

}  // namespace polhode
