// SPDX-License-Identifier: MIT
// The lengths of the chains of a replica, and the work for them.
#pragma once

#include <algorithm>
#include <cstddef>

#include "run/properties/coupling.hpp"
#include "run/properties/elongate.hpp"
#include "run/properties/replica.hpp"

namespace polhode {

/// Segments of each kind that a replica needs at least.
struct Target {
  std::size_t averages = 0, dynamics = 0, elongated = 0, coupled = 0;
};

/// The work of a preparation, as steps of hoa2 with the same number of force evaluations.
inline constexpr double steps_of_preparation = 8000;
/// Steps of a segment of dynamics.
inline constexpr double steps_of_dynamics = steps_of_lags * windows_in_segment;

/// Segments and preparations that a replica still needs.
inline std::size_t missing(const Replica& replica, const Target& target) {
  const auto rest = [](std::size_t wanted, std::size_t there) {
    return wanted - std::min(wanted, there);
  };
  return (replica.prepared() ? 0 : 1) + rest(target.averages, replica.averages.size()) +
         rest(target.dynamics, replica.dynamics.size()) +
         rest(target.elongated, replica.elongated.segments.size()) +
         rest(target.coupled, replica.coupled.segments.size());
}

inline bool has(const Replica& replica, const Target& target) {
  return missing(replica, target) == 0;
}

/// Steps of a number of segments at all stages of a coupling.
inline double steps_of_coupled(std::size_t segments, std::size_t stages) {
  return static_cast<double>(segments * stages * steps_of_coupling);
}

/// Steps of a replica. A step of the long box counts as a step of each of its copies.
inline double steps_of(const Replica& replica) {
  const auto segments = static_cast<double>(replica.dynamics.size() + 2 * replica.paired.size());
  const auto elongated = static_cast<double>(
      elongated_copies * (replica.elongated.segments.size() + 2 * replica.elongated.paired.size()));
  return (replica.prepared() ? steps_of_preparation : 0) +
         static_cast<double>(replica.averages.size()) * steps_of_averages +
         steps_of_coupled(replica.coupled.segments.size(), replica.coupled.path.size()) +
         (segments + elongated) * steps_of_dynamics;
}

/// Steps of a number of segments of dynamics, with their pairs at half of the step.
inline double steps_of_dynamics_of(std::size_t segments, bool paired_runs) {
  const std::size_t pairs = paired_runs ? (segments + paired_every - 1) / paired_every : 0;
  return static_cast<double>(segments + 2 * pairs) * steps_of_dynamics;
}
/// The same in the long box.
inline double steps_of_elongated(std::size_t segments, bool paired_runs) {
  return elongated_copies * steps_of_dynamics_of(segments, paired_runs);
}

/// Steps of a replica that has reached a target.
/// @param stages  number of stages of a coupling
inline double steps_at(const Target& target, std::size_t stages, bool paired_runs) {
  return steps_of_preparation + static_cast<double>(target.averages * steps_of_averages) +
         steps_of_dynamics_of(target.dynamics, paired_runs) +
         steps_of_elongated(target.elongated, paired_runs) +
         steps_of_coupled(target.coupled, stages);
}
/// Steps that a replica lacks until it reaches a target.
inline double steps_missing(const Replica& replica, const Target& target, std::size_t stages,
                            bool paired_runs) {
  const Target end{std::max(target.averages, replica.averages.size()),
                   std::max(target.dynamics, replica.dynamics.size()),
                   std::max(target.elongated, replica.elongated.segments.size()),
                   std::max(target.coupled, replica.coupled.segments.size())};
  return std::max(0.0, steps_at(end, stages, paired_runs) - steps_of(replica));
}

}  // namespace polhode
