// SPDX-License-Identifier: MIT
// The system of a state point, which all of its replicas share.
#pragma once

#include <string>

#include "polhode/model/topology.hpp"
#include "polhode/run/properties/measure.hpp"
#include "run/properties/replica.hpp"

namespace polhode {

/// Data that all replicas of a state point share.
struct PointSystem {
  ReplicaSettings common;
  Topology topology;
  Mixing mixing;
  std::string identity;

  /// @throws Error  if the system cannot be built, or its density is not the density of a liquid
  PointSystem(const MeasureSettings& settings, const StatePoint& at);
};

/// @throws Error  if the system does not have a requested property at all state points
void check_properties(const MeasureSettings& settings, const Topology& topology);

}  // namespace polhode
