// SPDX-License-Identifier: MIT
// The values of properties from the replicas of a state point.
#pragma once

#include <span>

#include "polhode/run/properties/measure.hpp"
#include "run/properties/replica.hpp"

namespace polhode {

/// All replicas of a state point, and what their system is.
struct PointData {
  const Topology& topology;
  const Mixing& mixing;
  StatePoint at;
  std::span<const Replica> replicas;
};

/// Whether each replica has at least as many segments in equilibrium as before it.
bool in_equilibrium(const PointData& data);

/// A property with its error; not known before there is enough data.
MeasuredProperty estimate(const RequestedProperty& request, const PointData& data);

/// Conditions, lengths, steps and curves; without properties.
MeasuredPoint described(const PointData& data);

/// The property from the first parts of the data.
std::vector<SeriesEstimate> stages_of(const RequestedProperty& request, const PointData& data);

}  // namespace polhode
