// SPDX-License-Identifier: MIT
#include "run/properties/expected_time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "io/settings/output_units.hpp"
#include "polhode/base/error.hpp"
#include "run/properties/property.hpp"

namespace polhode {
namespace {

double steps_of(const MeasuredProperty& m, const WorkDone& done) {
  return done.steps[m.request.property->measured_in];
}

/// An error as it is requested: "0.1 %" or "0.05 kJ/mol".
std::string error_text(const MeasuredProperty& m, double error) {
  if (m.request.relative) return fmt::format("{:.2g} %", 100 * error / std::abs(m.value.value));
  const std::string unit = m.request.property->unit;
  return fmt::format("{:.2g}{}{}", error, unit.empty() ? "" : " ", unit);
}

/// A length in whole ps, or with two digits if it is short.
std::string ps_text(double length) {
  return length < 10 ? fmt::format("{:.2g} ps", length) : fmt::format("{:.0f} ps", length);
}

}  // namespace

std::string duration_text(double seconds) {
  struct Unit {
    double until, seconds;  // [s]
    const char* name;
  };
  constexpr double minute = 60, hour = 3600, day = 86400, year = 365.25 * day;
  constexpr std::array shorter = {Unit{2 * minute, 1, "s"}, Unit{2 * hour, minute, "min"},
                                  Unit{2 * day, hour, "h"}, Unit{2 * year, day, "days"}};
  for (const auto& [until, unit, name] : shorter)
    if (seconds < until) return fmt::format("{:.0f} {}", seconds / unit, name);
  return fmt::format("{:.2g} years", seconds / year);
}

std::string plan_text(const ReplicaSettings& settings, const Target& target, std::size_t replicas,
                      std::size_t molecules, double seconds) {
  const double step = settings.step;
  const auto segments = [&](MeasuredIn kind) { return static_cast<double>(target[kind]); };
  const double dynamics = (segments(MeasuredIn::dynamics) + segments(MeasuredIn::elongated) +
                           segments(MeasuredIn::conduction)) *
                          steps_of_dynamics;
  std::string text = fmt::format(
      "plan at {}: {} replicas of {} molecules, {} at {:g} fs; first {} of each at "
      "constant {}",
      settings.at.text(), replicas, molecules, text_of(settings.sampling, settings.scheme),
      step * units::fs_per_ps, ps_text(segments(MeasuredIn::averages) * steps_of_averages * step),
      settings.at.constant_volume() ? "volume" : "pressure");
  if (dynamics > 0)
    text += fmt::format(
        " and {} for dynamics{}", ps_text(dynamics * step),
        settings.paired_runs ? ", of which an eighth is repeated at half of the step" : "");
  if (target[MeasuredIn::coupling] > 0)
    text += fmt::format(" and {} at each of {} stages of the coupling of a molecule",
                        ps_text(segments(MeasuredIn::coupling) * steps_of_coupling * step),
                        settings.path.size());
  if (target[MeasuredIn::slab] > 0)
    text += fmt::format(" and {} of a slab of {} molecules",
                        ps_text(segments(MeasuredIn::slab) * steps_of_averages * step),
                        slab_copies * molecules);
  if (seconds > 0) text += fmt::format(", about {}", duration_text(seconds));
  return text + "; longer where an error is not reached";
}

std::optional<double> expected_time(const MeasuredProperty& m, double error, const WorkDone& done) {
  if (m.request.property->measured_in == MeasuredIn::pair || m.value.known != Known::yes ||
      !m.obstacle.empty() || !(done.seconds_per_step > 0))
    return std::nullopt;
  const double longer = std::pow(m.value.error / error, 2);
  return std::max(0.0, longer - 1) * steps_of(m, done) * done.seconds_per_step;
}

double reachable_error(const MeasuredProperty& m, double seconds, const WorkDone& done) {
  const double steps = steps_of(m, done);
  return m.value.error * std::sqrt(steps / (steps + seconds / done.seconds_per_step));
}

std::optional<double> expected_time(std::span<const MeasuredProperty> values, double share,
                                    const WorkDone& done) {
  std::map<MeasuredIn, double> longest;  // one kind of run after the other
  for (const MeasuredProperty& m : values) {
    const std::optional<double> time = expected_time(m, share * m.requested_error(), done);
    if (!time) continue;
    double& of_kind = longest[m.request.property->measured_in];
    of_kind = std::max(of_kind, *time);
  }
  if (longest.empty()) return std::nullopt;
  double sum = 0;
  for (const auto& [kind, time] : longest) sum += time;
  return sum;
}

std::vector<std::string> time_warnings(std::span<const MeasuredProperty> values, double share,
                                       const WorkDone& done, const TimeAllowed& allowed) {
  constexpr double margin = 1.05;  // so that the error is still reachable when it is rounded
  std::vector<std::string> warnings;
  for (const MeasuredProperty& m : values) {
    const std::optional<double> time = expected_time(m, share * m.requested_error(), done);
    if (!time || *time <= allowed.seconds) continue;
    const std::string needs =
        fmt::format("{} with an error of {} needs about {}", m.request.property->name,
                    error_text(m, m.requested_error()), duration_text(*time));
    const auto reachable = [&](double seconds) {
      return error_text(m, margin * reachable_error(m, seconds, done) / share);
    };
    if (!allowed.is_limit && *time > max_time)
      throw Error(fmt::format(
          "{}; it must be less than a year: ask for an error of {}, which needs about {}, or give "
          "a time limit, at which the values so far are reported",
          needs, reachable(usual_time), duration_text(usual_time)));
    warnings.push_back(fmt::format(
        "{}; in {}{} an error of {} is reachable", needs, duration_text(allowed.seconds),
        allowed.is_limit ? ", the time limit," : "", reachable(allowed.seconds)));
  }
  return warnings;
}

}  // namespace polhode
