// SPDX-License-Identifier: MIT
// How long the replicas of a state point must become.
#pragma once

#include <string>
#include <vector>

#include "run/properties/contributions.hpp"
#include "run/properties/target.hpp"

namespace polhode {

/// Numbers of segments of each replica before the first decision, which are enough for errors to be
/// known. Lengths then grow by a factor. Frequent decisions would favour errors small by chance.
inline constexpr PerKind<std::size_t> first_segments{{first_averages, 4, 4, 12, 24, 4}};

/// The lengths that the requested properties need. Averages come first: other runs begin with their
/// mean volume, in equilibrium.
class Schedule {
 public:
  explicit Schedule(const MeasureSettings& settings) : settings_(settings) {}

  bool wants(MeasuredIn kind) const;
  /// The first lengths of all kinds of run.
  Target first() const;
  /// The standard error that the replicas must reach. With n shards, the replicas of a shard must
  /// reach only √n times the requested error.
  double required_error(const MeasuredProperty& m) const { return share() * m.requested_error(); }
  double share() const;
  /// Whether the replicas must become longer for a property. What prevents a value is often removed
  /// by longer runs, but not always.
  bool continues(const MeasuredProperty& m, const Target& target) const;
  /// Increases the target lengths for properties that have not reached their requested error.
  /// @return  whether work is left
  bool next(Target& target, const std::vector<MeasuredProperty>& values, bool equilibrium) const;
  /// Why the other kinds of run must not begin yet: they need equilibrium, and a mean volume whose
  /// error has no effect on them. Empty if they may, or after many averages.
  std::string why_not_yet(const Target& target, const PointData& data) const;

 private:
  const MeasureSettings& settings_;
};

/// The segments of averages in a target, and those of all other kinds of run.
Target averages_alone(const Target& target);
Target without_averages(Target target);
/// The next length of a kind of run.
std::size_t longer(std::size_t segments);

}  // namespace polhode
