// SPDX-License-Identifier: MIT
// The streams of random numbers and the use of each stream. Random numbers are functions of seed,
// use, step, stage and body. Random numbers do not depend on the number of threads or on the step
// at which a run was suspended.
#pragma once

#include <cstdint>

#include "polhode/integrate/step.hpp"

namespace polhode {

/// The uses of random numbers; no two uses share a random number.
enum class RandomUse : std::uint64_t {
  langevin = 1,
  thermostat,           ///< random numbers of the common or the translational factor
  thermostat_rotation,  ///< random numbers of the separate rotational factor
  cell_rescaling,
  volume_move,
  hybrid_momenta,
  hybrid_decision
};

/// The stream for a use, a stage and a step number below 2⁴⁸. Streams below 2⁵⁶ belong to initial
/// configurations and configurational temperatures.
constexpr std::uint64_t stream_of(RandomUse use, StageNumber at) {
  return static_cast<std::uint64_t>(use) << 56 | std::uint64_t{at.stage & 0xff} << 48 | at.step;
}

}  // namespace polhode
