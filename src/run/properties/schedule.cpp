// SPDX-License-Identifier: MIT
#include "run/properties/schedule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "run/properties/estimates.hpp"
#include "run/properties/property.hpp"

namespace polhode {
namespace {

/// Number of segments after which averages that have not reached equilibrium are not continued.
constexpr std::size_t max_equilibration = 600;
/// Growth of the first length after which a property without a value is not continued.
constexpr std::size_t max_without_value = 64;

/// Whether an error comes from the means of three or more replicas alone.
bool are_means_alone(const SeriesEstimate& value, std::uint64_t replicas) {
  constexpr double min_modes = 2;
  return value.modes >= min_modes && value.modes < static_cast<double>(replicas);
}

}  // namespace

std::size_t longer(std::size_t segments) {
  constexpr double growth = 1.5;
  return static_cast<std::size_t>(std::ceil(growth * static_cast<double>(segments)));
}

Target without_averages(Target target) {
  target[MeasuredIn::averages] = 0;
  return target;
}

Target averages_alone(const Target& target) {
  Target alone;
  alone[MeasuredIn::averages] = target[MeasuredIn::averages];
  return alone;
}

bool Schedule::wants(MeasuredIn kind) const {
  return std::ranges::any_of(settings_.properties,
                             [&](const auto& p) { return p.property->measured_in == kind; });
}

Target Schedule::first() const {
  Target target;
  for (const MeasuredIn kind : kinds_of_run)
    if (kind == MeasuredIn::averages || wants(kind)) target[kind] = first_segments[kind];
  return target;
}

double Schedule::share() const { return std::sqrt(static_cast<double>(settings_.shard.count)); }

bool Schedule::continues(const MeasuredProperty& m, const Target& target) const {
  const MeasuredIn kind = m.request.property->measured_in;
  if (kind == MeasuredIn::pair || !m.longer_helps) return false;
  const bool known = m.value.known == Known::yes && m.obstacle.empty();
  if (known && m.value.error <= required_error(m)) return false;
  // An error from the means of replicas alone does not fall.
  const bool falls = known && !(is_dynamics(kind) && are_means_alone(m.value, settings_.replicas));
  return falls || target[kind] < max_without_value * first_segments[kind];
}

bool Schedule::next(Target& target, const std::vector<MeasuredProperty>& values,
                    bool equilibrium) const {
  const auto any = [&](MeasuredIn what) {
    return std::ranges::any_of(values, [&](const MeasuredProperty& m) {
      return m.request.property->measured_in == what && continues(m, target);
    });
  };
  if (!equilibrium && target[MeasuredIn::averages] >= max_equilibration) return false;
  Target grown = target;
  for (const MeasuredIn kind : kinds_of_run)
    if ((kind == MeasuredIn::averages && !equilibrium) || any(kind))
      grown[kind] = longer(target[kind]);
  const bool has_grown = grown != target;
  target = grown;
  return has_grown;
}

std::string Schedule::why_not_yet(const Target& target, const PointData& data) const {
  // Transport coefficients of argon change by five times the relative change of the volume. A third
  // of the requested error then has no effect on the sum of squares.
  constexpr double sensitivity = 5, part = 1.0 / 3, usual_error = 0.01;
  const std::size_t averages = target[MeasuredIn::averages];
  if (!in_equilibrium(data))
    return averages < max_equilibration ? "a replica is not in equilibrium yet" : "";
  if (data.at.constant_volume() || averages >= max_without_value * first_averages) return "";
  double allowed = 1;
  for (const RequestedProperty& p : settings_.properties)
    if (is_dynamics(p.property->measured_in))
      allowed =
          std::min(allowed, share() * part / sensitivity * (p.relative ? p.error : usual_error));
  if (allowed == 1) return "";
  const SeriesEstimate V = estimate({&property("molar-volume")}, data).value;
  if (V.known != Known::yes) return "the error of the mean volume is not known yet";
  if (V.error <= allowed * V.value) return "";
  return fmt::format("dynamics needs a mean volume with an error of {:.2g} %, and it has {:.2g} %",
                     100 * allowed, 100 * V.error / V.value);
}

}  // namespace polhode
