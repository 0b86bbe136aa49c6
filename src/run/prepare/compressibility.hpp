// SPDX-License-Identifier: MIT
// The compressibility that a stage at constant pressure shows, which sets the size of the moves of
// its barostat.
#pragma once

#include "polhode/measure/energy_statistics.hpp"
#include "polhode/model/ensemble_settings.hpp"

namespace polhode {

/// The isothermal compressibility from the fluctuations of the volume in a stage [nm³ mol/kJ]. It
/// is known if its standard error is at most half of it, the stage has eight relaxation times of
/// the volume (whose variance then has a relative error of a half), and the volume does not drift:
/// one that still relaxes varies for another reason.
/// @param length  of the stage [ps]
SeriesEstimate measured_compressibility(const EnergyStatistics& energies,
                                        const BarostatSettings& barostat, double length, double kT);

/// The compressibility for the moves of the next stage [nm³ mol/kJ]: the measured one if it is
/// known. If it is not, and the volume drifts by more than it would fluctuate with the present one,
/// moves are too small, and the next compressibility is four times as large, within bounds. Moves
/// sample the same distribution with any.
/// @param barostat  of this stage
/// @param length    of this stage [ps]
double next_compressibility(const EnergyStatistics& energies, const BarostatSettings& barostat,
                            double length, double kT);

}  // namespace polhode
