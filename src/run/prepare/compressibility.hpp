// SPDX-License-Identifier: MIT
// The compressibility measured in a stage at constant pressure. The compressibility determines the
// size of barostat moves.
#pragma once

#include <string>

#include "polhode/measure/energy_statistics.hpp"
#include "polhode/model/ensemble_settings.hpp"

namespace polhode {

/// The isothermal compressibility from the volume fluctuations in a stage [nm³ mol/kJ]. The
/// compressibility is known only if its standard error is at most half of its value. In addition,
/// the volume must not drift, because the relaxation of the volume is not a fluctuation. The stage
/// must also have eight relaxation times of the volume, so that the variance has a relative error
/// of 1/2.
/// @param length  length of the stage [ps]
SeriesEstimate measured_compressibility(const EnergyStatistics& energies,
                                        const BarostatSettings& barostat, double length, double kT);

/// The compressibility that sets the size of moves in the next stage [nm³ mol/kJ]. If the
/// compressibility could be measured, the measured value is used. If not, the present value is
/// used, unless the volume drift exceeds the fluctuations that this value implies. In case of such
/// a drift, moves are too small, and the next value is four times as large, within bounds. The
/// sampled distribution does not depend on the compressibility that sets the size of moves.
/// @param barostat  settings of the barostat in this stage
/// @param length    length of this stage [ps]
double next_compressibility(const EnergyStatistics& energies, const BarostatSettings& barostat,
                            double length, double kT);

/// The compressibility as text, such as "310 ± 40 1e-6/bar, from the fluctuations of the volume",
/// or a text which says that the compressibility is not known yet.
/// @param in_use  compressibility that sets the size of the moves [nm³ mol/kJ]
std::string compressibility_text(const SeriesEstimate& measured, double in_use);

}  // namespace polhode
