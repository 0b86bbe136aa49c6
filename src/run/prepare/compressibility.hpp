// SPDX-License-Identifier: MIT
// The compressibility measured in a stage at constant pressure. The size of barostat moves is set
// according to the compressibility.
#pragma once

#include <string>

#include "polhode/measure/energy_statistics.hpp"
#include "polhode/model/ensemble_settings.hpp"

namespace polhode {

/// The isothermal compressibility from the volume fluctuations in a stage [nm³ mol/kJ]. The
/// compressibility is known only if its standard error is at most half of its value. In addition,
/// the volume must not drift, because the relaxation of the volume is not a fluctuation. The stage
/// must also last eight relaxation times of the volume, so that the variance has a relative error
/// of 1/2.
/// @param length  length of the stage [ps]
SeriesEstimate measured_compressibility(const EnergyStatistics& energies,
                                        const BarostatSettings& barostat, double length, double kT);

/// The compressibility that sets the size of moves in the next stage [nm³ mol/kJ]. If the
/// compressibility could be measured, the measured value is used. If the compressibility could not
/// be measured, the present value is used, unless the volume drifts by more than the fluctuations
/// that this value implies. Such a drift shows that moves are too small, so the next value is four
/// times as large, within bounds. The sampled distribution does not depend on the compressibility
/// that sets the size of moves.
/// @param barostat  settings of the barostat in this stage
/// @param length    length of this stage [ps]
double next_compressibility(const EnergyStatistics& energies, const BarostatSettings& barostat,
                            double length, double kT);

/// The compressibility as text, such as "310 ± 40 1e-6/bar, from the fluctuations of the volume",
/// or a text which says that the compressibility is not known yet.
/// @param in_use  compressibility that sets the size of the moves [nm³ mol/kJ]
std::string compressibility_text(const SeriesEstimate& measured, double in_use);

}  // namespace polhode
