// SPDX-License-Identifier: MIT
// A resumable run: its system, its current state, and its results so far.
#pragma once

#include <functional>
#include <optional>

#include "polhode/run/adviser/criterion.hpp"
#include "polhode/run/simulation/report/rounding.hpp"

namespace polhode {

struct ResumableRun {
  System system;
  std::uint64_t seed = 0;           ///< of its initial configuration
  std::optional<RunState> state{};  ///< nothing before the first step
};

/// Advances the run to the length given by the settings, bitwise as if it had never been suspended,
/// and returns the result of the whole run. The seed of the run replaces that of the settings.
/// @param noise  of the forces, for the R due to rounding alone
/// @param stop   suspends the run when it returns true
Outcome advance_run(ResumableRun& resumable, TrajectorySettings settings, const ForceNoise& noise,
                    const std::function<bool()>& stop = {});

}  // namespace polhode
