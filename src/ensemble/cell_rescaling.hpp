// SPDX-License-Identifier: MIT
// The stochastic equation of cell rescaling, in any consistent units.
#pragma once

#include <cmath>

namespace polhode {

/// Stochastic cell rescaling of λ = √V [bernetti2020]:
/// dλ = −(β λ/2τ) [P₀ − P − kT/(2V)] dt + √(kT β/2τ) dW.
struct CellEquation {
  double pressure;         ///< target pressure P₀
  double compressibility;  ///< estimated isothermal compressibility β
  double time_constant;    ///< τ
  double kT;

  /// dλ/dt without noise, at volume V and pressure P.
  double drift(double V, double P) const {
    return -compressibility * std::sqrt(V) / (2 * time_constant) * (pressure - P - kT / (2 * V));
  }
  /// The variance of the noise of λ in time t.
  double variance(double t) const { return kT * compressibility * t / (2 * time_constant); }
};

}  // namespace polhode
