// SPDX-License-Identifier: MIT
#include "run/adviser/step_search.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/settings/output_units.hpp"
#include "polhode/base/error.hpp"

namespace polhode {
namespace {

constexpr std::size_t max_points = 12;
constexpr double ladder = 1.25;  // ratio of successive steps if there is no power law to follow
constexpr double min_relative_step = 1.0 / 64;  // smallest step relative to the first step
constexpr double max_shrinking = 0.25;          // largest reduction of a step
constexpr double min_slope = 0.5;  // smallest slope of log R against log h, which round-off and
                                   // kinks reduce
constexpr double nearby =
    0.7;  // the model uses only steps above this fraction of the step at which R equals the bound

/// The points before the first unusable point, and the step of the unusable point.
struct Range {
  std::vector<AdviserPoint> usable;
  double end = std::numeric_limits<double>::infinity();  // step of the first unusable point [ps]
};

Range range_of(const std::vector<AdviserPoint>& points) {
  Range range;
  for (const AdviserPoint& point : points) {
    if (!point.usable) {
      range.end = point.step;
      break;
    }
    range.usable.push_back(point);
  }
  return range;
}

double log_ratio(const AdviserPoint& point) { return std::log(point.ratio().value); }

double exponent(const AdviserPoint& a, const AdviserPoint& b) {
  return (log_ratio(b) - log_ratio(a)) / std::log(b.step / a.step);
}

/// A step that is larger than the largest usable step, limited to a safe increase.
double longer(double proposed, double largest_usable, double end) {
  return std::min({proposed, max_growth * largest_usable, std::sqrt(largest_usable * end)});
}

/// The step at which the mean of log R equals the bound, extrapolated with the order of the scheme.
double meeting(const StepSearch& search, const Range& range) {
  const auto& p = range.usable;
  const double log_bound = std::log(search.criterion.bound);
  const double order = search.order == 0 ? 2 : search.order;
  if (log_ratio(p.front()) > log_bound) {
    const double slope = p.size() > 1 ? std::max(min_slope, exponent(p[0], p[1])) : order;
    const double step = p.front().step * std::exp((log_bound - log_ratio(p.front())) / slope);
    return std::max(step, max_shrinking * p.front().step);
  }
  for (std::size_t i = 0; i + 1 < p.size(); ++i)
    if (log_ratio(p[i + 1]) > log_bound)
      return p[i].step * std::exp((log_bound - log_ratio(p[i])) / exponent(p[i], p[i + 1]));
  const AdviserPoint& last = p.back();
  const double slope = p.size() > 1 ? std::max(order, exponent(p[p.size() - 2], last)) : order;
  return last.step * std::exp((log_bound - log_ratio(last)) / slope);
}

/// The step at which the mean of log R equals the bound, limited to a safe increase.
double crossing(const StepSearch& search, const Range& range) {
  const double at = meeting(search, range), largest_usable = range.usable.back().step;
  return at > largest_usable ? longer(at, largest_usable, range.end) : at;
}

bool is_measured(const std::vector<AdviserPoint>& points, double step, double within) {
  return std::any_of(points.begin(), points.end(), [&](const AdviserPoint& point) {
    return std::abs(std::log(point.step / step)) < within;
  });
}

std::optional<double> next_towards_ratio(const StepSearch& search, const Range& range) {
  const double at = crossing(search, range);
  if (at < min_relative_step * search.first) return std::nullopt;
  constexpr double near = 0.06, beside = 0.04;
  if (!is_measured(range.usable, at, near)) return at;
  for (const double part : {0.9, 0.8})
    if (!is_measured(range.usable, part * at, beside)) return part * at;
  return std::nullopt;
}

std::optional<double> next_of_ladder(const StepSearch& search, const Range& range) {
  const auto& p = range.usable;
  const auto meets = [&](const AdviserPoint& point) {
    return point.bound <= search.criterion.bound;
  };
  const auto broken =
      std::find_if(p.begin(), p.end(), [&](const AdviserPoint& point) { return !meets(point); });
  if (broken == p.begin()) {
    // A smaller step reduces a bias, but not the noise of the measured bias, so two smaller steps
    // are tried.
    const double step = p.front().step / ladder;
    return step > 0.6 * search.first ? std::optional(step) : std::nullopt;
  }
  const double largest_met = std::prev(broken)->step;
  const double beyond = broken == p.end() ? range.end : broken->step;
  const double next = longer(ladder * largest_met, largest_met, beyond);
  return next > 1.06 * largest_met ? std::optional(next) : std::nullopt;
}

}  // namespace

void check_forces(double frequency, const std::string& source) {
  // The Einstein frequency exceeds 0.1 per ps in any liquid and in most gases. If the frequency is
  // far lower, the forces are only round-off errors.
  constexpr double min_frequency = 1e-6;
  if (!(frequency > min_frequency))
    throw Error(
        "the forces in the initial configuration are nearly zero, as on a perfect lattice, so the "
        "first step cannot be estimated; equilibrate first, for example with equilibrate = \"5 "
        "ps\" in [run]",
        source);
}

void check_length(double length, double first, std::string_view scheme) {
  if (length < 10 * first)
    throw Error(
        fmt::format("runs of {:g} fs are too short for advice; a run must have at least ten steps "
                    "of {:.3g} fs, the first time step tried with the scheme {}: use longer runs",
                    units::fs_per_ps * length, units::fs_per_ps * first, scheme));
}

double three_digits(double step) {
  const double unit = std::pow(10, std::floor(std::log10(step)) - 2);
  return std::floor(step / unit * (1 + 1e-12)) * unit;
}

std::optional<double> lengthened(double step, double reached, double exponent, double too_long) {
  constexpr double max_ratio = 1.25, min_ratio = 1.02;
  if (!(reached > 0) || reached >= max_caution) return std::nullopt;
  const double proposed = step * std::min(max_ratio, std::pow(aim / reached, 1 / exponent));
  const double longer = three_digits(std::min(proposed, std::sqrt(step * too_long)));
  return longer >= min_ratio * step ? std::optional(longer) : std::nullopt;
}

double shortening(const Criterion& criterion, const std::vector<Outcome>& runs,
                  std::size_t whole_set, double part, double exponent) {
  double excess = optimistic_bound(runs, part) / criterion.bound;
  if (runs.size() < whole_set) {
    // The scatter of an incomplete set of runs is poorly known. If the first run exceeds the
    // required bound by x %, the prediction bound of eight runs exceeds the required bound by about
    // 2x %.
    excess = std::pow(std::ranges::max(each(runs, &Outcome::ratio)) / criterion.bound, 2);
  }
  return std::clamp(std::pow(excess, -1 / exponent), 0.6, 0.97);
}

std::optional<double> next_step(const StepSearch& search, const std::vector<AdviserPoint>& points) {
  if (points.size() >= max_points) return std::nullopt;
  if (points.empty()) return search.first;
  const Range range = range_of(points);
  if (range.usable.empty())
    return range.end > min_relative_step * search.first ? std::optional(range.end / 2)
                                                        : std::nullopt;
  return search.criterion.quality == Quality::ratio ? next_towards_ratio(search, range)
                                                    : next_of_ladder(search, range);
}

double max_expected_step(const StepSearch& search, const std::vector<AdviserPoint>& points) {
  const Range range = range_of(points);
  if (search.criterion.quality != Quality::ratio || range.usable.empty()) return range.end;
  return std::min(meeting(search, range), range.end);
}

bool decides(const StepSearch& search, const std::vector<AdviserPoint>& points, double step) {
  return search.criterion.quality != Quality::ratio ||
         (!points.empty() && step > nearby * max_expected_step(search, points));
}

FoundStep found_step(const StepSearch& search, const std::vector<AdviserPoint>& points) {
  const Range range = range_of(points);
  if (range.usable.empty()) return {};
  if (search.criterion.quality != Quality::ratio) {
    FoundStep found;
    for (const AdviserPoint& point : range.usable) {
      if (point.bound > search.criterion.bound) break;
      found.step = point.step;
    }
    return found;
  }
  const double at = crossing(search, range);
  std::vector<StepPoint> around;
  for (const AdviserPoint& point : range.usable)
    if (point.step > nearby * at && point.step < 1.1 * at)
      around.push_back({point.step, each(point.runs, &Outcome::ratio)});
  if (around.size() < 2) return {};
  FoundStep found{0, StepModel(search.order, around)};
  const double largest_usable = around.back().step;
  const double step =
      found.model->max_step(search.criterion.bound, guarantee_probability, largest_usable);
  // A model with two or three points is not extrapolated far.
  if (step > 0.6 * around.front().step) found.step = step;
  return found;
}

}  // namespace polhode
