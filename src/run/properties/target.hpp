// SPDX-License-Identifier: MIT
// The lengths of the chains of a replica, the work for them, and its next pieces.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <string>

#include "run/properties/coupling.hpp"
#include "run/properties/replica.hpp"
#include "run/properties/slab.hpp"

namespace polhode {

/// The kinds of run, in the order in which a replica performs them.
inline constexpr std::array kinds_of_run{MeasuredIn::averages,  MeasuredIn::dynamics,
                                         MeasuredIn::elongated, MeasuredIn::coupling,
                                         MeasuredIn::slab,      MeasuredIn::conduction};

/// A number for each kind of run.
template <class Number>
struct PerKind {
  std::array<Number, kinds_of_run.size()> of{};
  constexpr Number& operator[](MeasuredIn kind) { return of[static_cast<std::size_t>(kind)]; }
  constexpr Number operator[](MeasuredIn kind) const { return of[static_cast<std::size_t>(kind)]; }
  Number sum() const { return std::accumulate(of.begin(), of.end(), Number{}); }
  friend bool operator==(const PerKind&, const PerKind&) = default;
};

/// Segments of each kind that a replica needs at least.
using Target = PerKind<std::size_t>;

/// The work of a preparation, as steps of hoa2 with the same number of force evaluations.
inline constexpr double steps_of_preparation = 8000;
/// Steps of a segment of dynamics.
inline constexpr double steps_of_dynamics = steps_of_lags * windows_in_segment;

/// The work of a step with its share of the heat flux, in steps.
inline constexpr double work_of_heat_flux = 2.5;

/// Segments and preparations that a replica still needs.
inline std::size_t missing(const Replica& replica, const Target& target) {
  std::size_t sum = replica.prepared() ? 0 : 1;
  for (const MeasuredIn kind : kinds_of_run)
    sum += target[kind] - std::min(target[kind], length_of(replica, kind));
  return sum;
}

inline bool has(const Replica& replica, const Target& target) {
  return missing(replica, target) == 0;
}

/// Steps of segments of a kind of run. A step of several copies counts as a step of each.
/// @param paired  segments that are repeated at half of the step
/// @param stages  stages of a coupling
inline double steps_of(MeasuredIn kind, std::size_t segments, std::size_t paired,
                       std::size_t stages) {
  constexpr PerKind<double> of_segment{
      {steps_of_averages, steps_of_dynamics, steps_of_dynamics * elongated_copies,
       steps_of_coupling, steps_of_averages * slab_copies, steps_of_dynamics * work_of_heat_flux}};
  const std::size_t at_once = kind == MeasuredIn::coupling ? stages : 1;
  return of_segment[kind] * static_cast<double>((segments + 2 * paired) * at_once);
}

/// Steps of segments of a kind of run that are still to be made, with their pairs.
inline double steps_of_kind(MeasuredIn kind, std::size_t segments,
                            const ReplicaSettings& settings) {
  const bool is_paired = settings.paired_runs && is_dynamics(kind);
  const std::size_t pairs = is_paired ? (segments + paired_every - 1) / paired_every : 0;
  return steps_of(kind, segments, pairs, settings.path.size());
}

/// Steps of a replica.
inline double steps_of(const Replica& replica) {
  double sum = replica.prepared() ? steps_of_preparation : 0;
  for (const MeasuredIn kind : kinds_of_run) {
    const DynamicsChain* const chain = chain_of(replica, kind);
    sum += steps_of(kind, length_of(replica, kind), chain ? chain->paired.size() : 0,
                    replica.coupled.path.size());
  }
  return sum;
}

/// Steps of a replica that has reached a target.
inline double steps_at(const Target& target, const ReplicaSettings& settings) {
  double sum = steps_of_preparation;
  for (const MeasuredIn kind : kinds_of_run) sum += steps_of_kind(kind, target[kind], settings);
  return sum;
}

/// Steps that a replica lacks until it reaches a target.
inline double steps_missing(const Replica& replica, const Target& target,
                            const ReplicaSettings& settings) {
  Target end;
  for (const MeasuredIn kind : kinds_of_run)
    end[kind] = std::max(target[kind], length_of(replica, kind));
  return std::max(0.0, steps_at(end, settings) - steps_of(replica));
}

/// Performs the next piece of work of a replica that lacks something.
/// @return  false if it was stopped
bool extend_by_one(Replica& replica, const Target& target, const ReplicaSettings& settings);

/// The next task of a replica that lacks something, for an executor: a few segments, so that little
/// is lost if the executor is killed. Its state point is not set.
ReplicaTask next_task(const Replica& replica, const Target& target, const ReplicaSettings& settings,
                      const std::string& identity);

}  // namespace polhode
