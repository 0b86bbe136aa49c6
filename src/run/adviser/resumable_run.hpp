// SPDX-License-Identifier: MIT
// A resumable run: the system, the current state, and the results so far.
#pragma once

#include <functional>
#include <optional>

#include "polhode/run/adviser/criterion.hpp"
#include "polhode/run/simulation/report/rounding.hpp"

namespace polhode {

struct ResumableRun {
  System system;
  std::uint64_t seed = 0;           ///< seed of the run's initial configuration
  std::optional<RunState> state{};  ///< state of the run; empty before the first step
};

/// Advances a run to the length in the settings, and returns the result of the whole run. The
/// result is bitwise identical to the result of an uninterrupted run. The seed of the run replaces
/// the seed of the settings.
/// @param noise  noise of the forces, which gives the round-off limit of R
/// @param stop   the run is suspended when this function returns true
Outcome advance_run(ResumableRun& resumable, TrajectorySettings settings, const ForceNoise& noise,
                    const std::function<bool()>& stop = {});

}  // namespace polhode
