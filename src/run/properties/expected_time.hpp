// SPDX-License-Identifier: MIT
// How long a measurement will take, from the errors that it has reached so far.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "polhode/run/properties/measure.hpp"
#include "run/properties/target.hpp"

namespace polhode {

/// The work of all replicas of a state point so far.
struct WorkDone {
  PerKind<double> steps{};      ///< steps of all replicas together
  double seconds_per_step = 0;  ///< wall-clock time divided by the steps of all replicas [s]
};

/// The time [s] for which a measurement may run.
struct TimeAllowed {
  double seconds = 0;
  bool is_limit = false;  ///< whether a time limit ends it; otherwise it is what most users accept
};

/// Without a time limit a longer expected time is a warning [s].
inline constexpr double usual_time = 30 * 86400.0;
/// Without a time limit a longer expected time is an error [s].
inline constexpr double max_time = 365.25 * 86400.0;

/// The first lengths of the replicas of a state point, and how long they take.
/// @param settings  with the time step, and the stages of a coupling
/// @param seconds   expected wall-clock time; 0 if it is not known
std::string plan_text(const ReplicaSettings& settings, const Target& target, std::size_t replicas,
                      std::size_t molecules, double seconds);

/// The time until a property has a standard error [s], which falls with the square root of the
/// length; 0 if it has. Empty if its error is not known, or no time has been measured.
std::optional<double> expected_time(const MeasuredProperty& m, double error, const WorkDone& done);

/// The standard error that a property reaches in a time [s] if all of it is spent on this property.
double reachable_error(const MeasuredProperty& m, double seconds, const WorkDone& done);

/// The time until all properties have reached their errors [s]: averages and dynamics one after the
/// other. Empty if it is known of none.
/// @param share  factor of the requested errors, for a part of the replicas
std::optional<double> expected_time(std::span<const MeasuredProperty> values, double share,
                                    const WorkDone& done);

/// A line for each property whose error needs longer than is allowed: the time, and the error that
/// is reachable.
/// @throws Error  if it is longer than `max_time`, without a time limit
std::vector<std::string> time_warnings(std::span<const MeasuredProperty> values, double share,
                                       const WorkDone& done, const TimeAllowed& allowed);

/// "40 s", "12 min", "3 h", "50 days", "2.5 years".
std::string duration_text(double seconds);

}  // namespace polhode
