// SPDX-License-Identifier: MIT
// The next pieces of work of a replica.
#include <algorithm>

#include "run/properties/point_system.hpp"
#include "run/properties/replica_file.hpp"
#include "run/properties/target.hpp"

namespace polhode {

bool extend_by_one(Replica& replica, const Target& target, const ReplicaSettings& settings) {
  using AddSegment = bool (*)(Replica&, const ReplicaSettings&);
  constexpr PerKind<AddSegment> add{
      {add_averages, add_dynamics, add_elongated, add_coupling, add_slab, add_conduction}};
  if (!replica.prepared()) return prepare(replica, settings);
  const auto lacking = std::ranges::find_if(
      kinds_of_run, [&](auto kind) { return length_of(replica, kind) < target[kind]; });
  return add[*lacking](replica, settings);
}

ReplicaTask next_task(const Replica& replica, const Target& target, const ReplicaSettings& settings,
                      const std::string& identity) {
  constexpr std::size_t at_once = 8;
  ReplicaTask task{.replica = replica.index,
                   .step = settings.step,
                   .record = replica_bytes(replica, identity),
                   .path = settings.path};
  bool is_longer = false;
  for (const MeasuredIn kind : kinds_of_run) {
    const std::size_t now = length_of(replica, kind);
    const bool extends = !is_longer && now < target[kind],
               is_short = kind == MeasuredIn::averages || kind == MeasuredIn::slab;
    task.segments.push_back(extends ? std::min(target[kind], now + (is_short ? at_once : 1)) : now);
    is_longer = is_longer || extends;
  }
  return task;
}

std::string perform(const MeasureSettings& settings, const ReplicaTask& task) {
  PointSystem system(settings, settings.points.at(task.point));
  system.common.step = task.step;
  system.common.path = task.path;
  Replica replica = task.record.empty() ? Replica{.index = task.replica}
                                        : parse_replica(task.record, "the record of a task",
                                                        task.replica, system.identity);
  Target target;
  std::copy_n(task.segments.begin(), std::min(task.segments.size(), target.of.size()),
              target.of.begin());
  while (!has(replica, target)) extend_by_one(replica, target, system.common);
  return replica_bytes(replica, system.identity);
}

}  // namespace polhode
