// SPDX-License-Identifier: MIT
// The next pieces of work of a replica.
#pragma once

#include <string>

#include "run/properties/target.hpp"

namespace polhode {

/// Performs the next piece of work of a replica that lacks something.
/// @return  false if it was stopped
bool extend_by_one(Replica& replica, const Target& target, const ReplicaSettings& settings);

/// The next task of a replica that lacks something, for an executor: a few segments, so that little
/// is lost if the executor is killed. Its state point is not set.
ReplicaTask next_task(const Replica& replica, const Target& target, const ReplicaSettings& settings,
                      const std::string& identity);

}  // namespace polhode
