// SPDX-License-Identifier: MIT
#include "run/properties/replica_task.hpp"

#include <algorithm>

#include "run/properties/contributions.hpp"
#include "run/properties/coupling.hpp"
#include "run/properties/point_system.hpp"
#include "run/properties/replica_file.hpp"

namespace polhode {

bool extend_by_one(Replica& replica, const Target& target, const ReplicaSettings& settings) {
  if (!replica.prepared()) return prepare(replica, settings);
  if (replica.averages.size() < target.averages) return add_averages(replica, settings);
  if (replica.dynamics.size() < target.dynamics)
    return add_dynamics(replica, settings, equilibrated(replica));
  if (replica.elongated.segments.size() < target.elongated)
    return add_elongated(replica, settings, equilibrated(replica));
  return add_coupling(replica, settings);
}

ReplicaTask next_task(const Replica& replica, const Target& target, const ReplicaSettings& settings,
                      const std::string& identity) {
  constexpr std::size_t at_once = 8;
  ReplicaTask task{.replica = replica.index,
                   .averages = replica.averages.size(),
                   .dynamics = replica.dynamics.size(),
                   .step = settings.step,
                   .record = replica_bytes(replica, identity),
                   .elongated = replica.elongated.segments.size(),
                   .coupled = replica.coupled.segments.size(),
                   .path = settings.path};
  if (task.averages < target.averages)
    task.averages = std::min(target.averages, task.averages + at_once);
  else if (task.dynamics < target.dynamics)
    ++task.dynamics;
  else if (task.elongated < target.elongated)
    ++task.elongated;
  else
    ++task.coupled;
  return task;
}

std::string perform(const MeasureSettings& settings, const ReplicaTask& task) {
  PointSystem system(settings, settings.points.at(task.point));
  system.common.step = task.step;
  system.common.path = task.path;
  Replica replica = task.record.empty() ? Replica{.index = task.replica}
                                        : parse_replica(task.record, "the record of a task",
                                                        task.replica, system.identity);
  const Target target{task.averages, task.dynamics, task.elongated, task.coupled};
  while (!has(replica, target)) extend_by_one(replica, target, system.common);
  return replica_bytes(replica, system.identity);
}

}  // namespace polhode
