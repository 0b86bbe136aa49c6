// SPDX-License-Identifier: MIT
// The barostat of a replica.
#pragma once

#include "polhode/model/ensemble_settings.hpp"
#include "run/properties/replica.hpp"

namespace polhode {

/// The barostat of segments with a time step.
/// @param compressibility  compressibility that sets the size of its moves [nm³ mol/kJ]
BarostatSettings barostat(const ReplicaSettings& settings, double compressibility, double step);

/// The compressibility that sets the size of moves in the next segment of averages [nm³ mol/kJ].
/// It follows from the volume fluctuations of the later half of the segments, once this half lasts
/// eight relaxation times of the barostat. With a value far too small, the volume would relax so
/// slowly that segments are correlated; with a value far too large, moves would overshoot. The
/// value is therefore at most 16 times larger or smaller than that of the preparation. It changes
/// only when the number of segments has doubled. It is a function of these segments alone, so a
/// resumed replica has the same moves.
double compressibility_of_moves(const Replica& replica, const StatePoint& at);

}  // namespace polhode
