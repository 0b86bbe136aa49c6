// SPDX-License-Identifier: MIT
// The time scale of a system, and the longest step at which the scheme of a simulation is stable.
#pragma once

#include <optional>
#include <string>

#include "polhode/run/simulation/system/system.hpp"
#include "polhode/run/simulation/trajectory/trajectory_settings.hpp"

namespace polhode {

/// The Einstein frequency of the fastest degrees of freedom of a liquid [1/ps], from the forces in
/// a single state. The square of the frequency is ⟨f²⟩/(m k_B T) for translation, and ⟨τ_k²⟩/(J_k
/// k_B T) for rotation about each axis. Averages are taken over each kind of molecule separately.
double einstein_frequency(const System& system, const State& state,
                          Workers& workers = Workers::serial());

/// The fraction of the stability limit above which a warning is given. The fastest motions of a
/// liquid are about twice as fast as the Einstein frequency, so a warning at the limit would be too
/// late.
inline constexpr double near_stability = 0.4;

/// The step at which a run comes near the stability limit of its scheme [ps]. This step is
/// `near_stability` times the stability limit for the fastest degrees of freedom at given
/// positions. The step is infinite if nothing moves, and for nested schemes, whose stability limit
/// is not known.
double max_stable_step(const System& system, const State& state, const TrajectorySettings& settings,
                       Workers& workers = Workers::serial());

/// The step to try after a run blew up [ps]. The result is max_stable_step() at the initial
/// positions if this time step is shorter than the time step of the run. Otherwise the result is
/// half the time step of the run. The result is empty if molecules overlap at the initial
/// positions, because their forces give no information about the step.
std::optional<double> shorter_step(const System& system, const State& start,
                                   const TrajectorySettings& settings,
                                   Workers& workers = Workers::serial());

/// A step [ps] as text with two digits, such as "6.3 fs", for advice.
std::string rounded_fs(double step);

}  // namespace polhode
