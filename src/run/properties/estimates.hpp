// SPDX-License-Identifier: MIT
// The values of properties from the replicas of a state point.
#pragma once

#include <span>

#include "polhode/run/properties/measure.hpp"
#include "run/properties/replica.hpp"

namespace polhode {

/// The data of all replicas of a state point, with a description of the system.
struct PointData {
  const Topology& topology;
  const Mixing& mixing;
  StatePoint at;
  std::span<const Replica> replicas;
};

/// Whether each replica has at least as many segments in equilibrium as before it.
bool in_equilibrium(const PointData& data);

/// Estimates a property with its error. The error is not known until there is enough data.
MeasuredProperty estimate(const RequestedProperty& request, const PointData& data);

/// The conditions, lengths, steps and curves of a state point, without its properties.
MeasuredPoint described(const PointData& data);

/// Estimates of the property from increasing parts of the data.
std::vector<SeriesEstimate> stages_of(const RequestedProperty& request, const PointData& data);

}  // namespace polhode
