// SPDX-License-Identifier: MIT
// Diffusion and viscosity from dynamics in the long box of OrthoBoXY.
#pragma once

#include "run/properties/dynamics.hpp"

namespace polhode {

/// Estimates the diffusion coefficient D0 = (Dx + Dy)/2, or the viscosity, which is proportional to
/// 1/(Dx + Dy − 2 Dz) [busch2023].
void estimate_orthoboxy(MeasuredProperty& m, const Contributions& contributions,
                        double temperature);

}  // namespace polhode
