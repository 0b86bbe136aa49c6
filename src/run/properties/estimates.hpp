// SPDX-License-Identifier: MIT
// The values of properties from the replicas of a state point.
#pragma once

#include <vector>

#include "polhode/run/properties/measure.hpp"
#include "run/properties/contributions.hpp"

namespace polhode {

/// Estimates a property with its error. The error is not known until there is enough data.
MeasuredProperty estimate(const RequestedProperty& request, const PointData& data);

/// The conditions, lengths, steps and curves of a state point, without its properties.
MeasuredPoint described(const PointData& data);

/// Estimates of the property from increasing parts of the data.
std::vector<SeriesEstimate> stages_of(const RequestedProperty& request, const PointData& data);

}  // namespace polhode
