// SPDX-License-Identifier: MIT
// How long a step a simulation can take, by the stability of its scheme.
#pragma once

#include <optional>
#include <string>

#include "polhode/run/simulation/system/system.hpp"
#include "polhode/run/simulation/trajectory/trajectory_settings.hpp"

namespace polhode {

/// The fastest motions of a liquid are about twice as fast as its Einstein frequency, so a warning
/// at the stability limit itself would come too late.
inline constexpr double near_stability = 0.4;

/// The step at which a run comes near the stability limit of its scheme: `near_stability` of it,
/// for the fastest degrees of freedom at the positions of a state [ps]. Infinite if nothing moves,
/// and with an inner scheme, whose limit is not known.
double max_stable_step(const System& system, const State& state, const TrajectorySettings& settings,
                       Workers& workers = Workers::serial());

/// The step to try after a run blew up [ps]: max_stable_step() at the positions from which it
/// started, as the warning before the run has it; half of its own if that is longer. Nothing if
/// forces or torques there are beyond the bounds of relaxation.hpp: those of overlapping molecules
/// say nothing about the step.
std::optional<double> shorter_step(const System& system, const State& start,
                                   const TrajectorySettings& settings,
                                   Workers& workers = Workers::serial());

/// "6.3 fs": a step [ps] with two digits, for advice.
std::string rounded_fs(double step);

}  // namespace polhode
