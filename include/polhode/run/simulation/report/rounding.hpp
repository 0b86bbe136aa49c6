// SPDX-License-Identifier: MIT
// The contribution of mixed-precision rounding to R: the noise of the forces, measured on the
// system itself, and the random walk of the total energy that it drives.
#pragma once

#include "polhode/base/workers.hpp"
#include "polhode/integrate/nested_scheme.hpp"
#include "polhode/measure/energy_statistics.hpp"
#include "polhode/run/simulation/system/system.hpp"

namespace polhode {

/// Rounding noise of the forces and the energy of a system. Both are 0 in double precision.
struct ForceNoise {
  /// rms of Σ (p/m)·δf + ω·δτ over thermal momenta [kJ/mol/ps].
  double power = 0;
  /// rms of δV [kJ/mol].
  double energy = 0;
};

/// The largest number of bodies for which the noise is measured. The measurement takes about 30
/// force evaluations and a second force field, too much for a short run of a large system. Larger
/// systems use R_rounding of a smaller system of the same liquid, because the fluctuations of both
/// energies grow as the square root of the size.
inline constexpr std::size_t max_bodies_estimated = 20000;

/// Compares forces, torques and energy in the system's precision with double precision, for a few
/// states. The states are free drifts of 0.1 fs, which change only the last digits. Errors common
/// to all states, mainly from rounded charges, belong to a potential. The noise is the sample
/// variances s² of the differences. Components of p/m have the thermal variance k_B T/m, and
/// components of ω in the body frame have k_B T/J. Hence power² = k_B T Σ [s²(δf)/m + Σ_k
/// s²(δτ_k)/J_k], with T of the system.
ForceNoise force_noise(const System& system, Workers& workers = Workers::serial());

/// Σ w² over the force evaluations of one step, where the noise δf of an evaluation gives a kick w
/// h δf. Kicks at the same positions share one evaluation, and their weights add up, also from one
/// step to the next. A gradient kick of weight b, b {f + [f(q̃) − f]/λ}, has b (1 − 1/λ) of one
/// evaluation and b/λ of another. Velocity Verlet: 1; HOA2: (2η)² + (1 − 2η)²; GIER4 with λ = 1:
/// 5/9.
double kick_weights(const Scheme& scheme, double lambda);

/// Kick weights with an inner scheme, whose n steps in a drift of a h have weights of a/n: the
/// outer sum plus Σ a²/n times the inner one. Near and slow forces are both assumed to be as noisy
/// as the total forces. This is an upper estimate, because they share the noise of near pairs.
double kick_weights(const NestedScheme& scheme, double lambda);

/// Variance per time of the random walk of the total energy by the noise [(kJ/mol)²/ps]. Every
/// evaluation changes the energy by w h times an independent power, hence power² h Σw².
double rounding_walk(const ForceNoise& noise, const NestedScheme& scheme, double lambda,
                     double step);

/// Variance per time of the random walk of rounding in double precision. The upper estimate has 16
/// roundings of every energy per step, each 2⁻⁵³ of its size.
double double_walk(const Energies& energies, double step);

/// The largest energy drift by rounding in double precision [kJ/mol/ps], if all roundings have the
/// same sign.
double double_drift(const Energies& energies, double step);

/// The slope of the total energy [kJ/mol/ps]; 0 where it does not exceed double_drift(), as for
/// molecules without interactions.
double drift_rate(const EnergyStatistics& energies, double step);

/// The rms deviation of a random walk of this variance per time from its mean over a run. It is
/// √(rate t/6), from rate t/2 about its first value minus rate t/3 for the mean.
double walk_fluctuation(double rate, double length);

/// The rms deviation of the total energy from its mean by rounding in a run [kJ/mol]. It has a
/// random walk and the noise of the energy: σ² = power² h t Σw²/6 + energy².
double rounding_fluctuation(const ForceNoise& noise, const NestedScheme& scheme, double lambda,
                            double step, double length);

/// Rounding dominates R below this multiple of the R of rounding. The two errors add in quadrature,
/// so R is then at least 15 % larger than in double precision.
inline constexpr double rounding_margin = 2;

}  // namespace polhode
