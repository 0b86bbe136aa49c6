// SPDX-License-Identifier: MIT
// The thermal conductivity by the Green-Kubo relation.
#pragma once

#include "polhode/run/properties/measure.hpp"
#include "run/properties/contributions.hpp"

namespace polhode {

/// The thermal conductivity [W/(m K)] per spectrum of the heat flux times the root of the volume.
double conductivity_per_spectrum(double temperature);

/// Estimates the thermal conductivity: the spectrum of the heat flux J at zero frequency is twice
/// the integral of its autocorrelation function, so λ = V S(0)/(2 k T²) [evans1989].
void thermal_conductivity(MeasuredProperty& m, const Contributions& contributions,
                          const PointData& data);

}  // namespace polhode
