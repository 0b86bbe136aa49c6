// SPDX-License-Identifier: MIT
// A run that may be left and gone on with: its system, where it stands, and what it has shown.
#pragma once

#include <functional>
#include <optional>

#include "polhode/run/criterion.hpp"
#include "polhode/run/rounding.hpp"

namespace polhode {

struct Course {
  System system;
  std::uint64_t seed = 0;           ///< of its start
  std::optional<RunState> state{};  ///< nothing before the first step
};

/// Moves the run on until the settings' length, as if it had never been left, and tells what the
/// whole of it shows. Of the settings' seed the course's takes the place.
/// @param noise  of the forces, for the R that rounding alone makes
/// @param stop   leaves the run where it is
Outcome moved(Course& course, TrajectorySettings settings, const ForceNoise& noise,
              const std::function<bool()>& stop = {});

}  // namespace polhode
