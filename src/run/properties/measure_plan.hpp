// SPDX-License-Identifier: MIT
// The plan of a measurement: what its first lengths are, and how long they take.
#pragma once

#include <string>

#include "run/properties/target.hpp"

namespace polhode {

/// The first lengths of the replicas of a state point.
struct Plan {
  const ReplicaSettings& settings;  ///< with the time step, and the stages of a coupling
  Target target;
  std::size_t replicas = 0, molecules = 0;
  bool paired_runs = true;

  /// Steps of all replicas together.
  double steps() const;
  /// @param seconds  expected wall-clock time; 0 if it is not known
  std::string text(double seconds) const;
};

}  // namespace polhode
