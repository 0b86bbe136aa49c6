// SPDX-License-Identifier: MIT
// The contribution of mixed-precision rounding to R. The noise of the forces drives a random walk
// of the total energy. The noise is measured for the simulated system.
#pragma once

#include "polhode/base/workers.hpp"
#include "polhode/integrate/nested_scheme.hpp"
#include "polhode/measure/energy_statistics.hpp"
#include "polhode/run/simulation/system/system.hpp"

namespace polhode {

/// Round-off noise of the forces and the energy of a system. In double precision, both numbers are
/// 0.
struct ForceNoise {
  /// Rms of the power Σ (p/m)·δf + ω·δτ over thermal momenta [kJ/mol/ps].
  double power = 0;
  /// Rms of the energy noise δV [kJ/mol].
  double energy = 0;
};

/// The largest number of bodies for which the noise is measured. The measurement takes about 30
/// force evaluations and a second force field. This cost is too high for a short run of a large
/// system. For a larger system, measure the round-off limit of R in a smaller system of the same
/// liquid. The limit is the same, because the fluctuations of the total and the potential energy
/// both grow as the square root of the size.
inline constexpr std::size_t max_bodies_estimated = 20000;

/// Measures the round-off noise for a few states. The forces, torques and energy in the precision
/// of the system are compared with their values in double precision. The states differ by free
/// drifts of 0.1 fs, which change only the last digits of positions. Errors common to all states,
/// mainly from rounded charges, derive from a potential and are not noise. The noise is given by
/// the sample variances s² of the differences. Components of p/m have the thermal variance k_B T/m,
/// and components of ω in the body frame have k_B T/J. Hence power² = k_B T Σ [s²(δf)/m + Σ_k
/// s²(δτ_k)/J_k] at the temperature T of the system.
ForceNoise force_noise(const System& system, Workers& workers = Workers::serial());

/// The sum Σ w² over the force evaluations of a step. The force noise δf of an evaluation changes
/// the momenta by w h δf, which defines the weight w of the evaluation. Kicks at the same positions
/// share an evaluation, and the weights of these kicks are added. Kicks on both sides of a step
/// boundary also share an evaluation. A gradient kick b {f + [f(q̃) − f]/λ} of weight b has the
/// weight b (1 − 1/λ) for the evaluation at q and b/λ for the evaluation at q̃. The sum is 1 for
/// velocity Verlet, (2η)² + (1 − 2η)² for HOA2, and 5/9 for GIER4 with λ = 1.
double kick_weights(const Scheme& scheme, double lambda);

/// The sum of squared kick weights of a nested scheme. A drift of length a h consists of n inner
/// steps, each with the weight a/n. The result is therefore the outer sum plus Σ a²/n times the
/// inner sum. Near and slow forces are both assumed to be as noisy as the total forces. This
/// assumption overestimates the total noise, because near and slow forces share the noise of near
/// pairs.
double kick_weights(const NestedScheme& scheme, double lambda);

/// Variance per time of the random walk of the total energy that the force noise causes
/// [(kJ/mol)²/ps]. Every evaluation changes the energy by w h times an independent random power.
/// The sum is the rate power² h Σw².
double rounding_walk(const ForceNoise& noise, const NestedScheme& scheme, double lambda,
                     double step);

/// Variance per time of the random walk of the energy by round-off in double precision. This upper
/// estimate assumes 16 roundings of every energy per step, each with a relative error of 2⁻⁵³.
double double_walk(const Energies& energies, double step);

/// The largest possible energy drift by round-off in double precision [kJ/mol/ps], which occurs if
/// all round-off errors have the same sign.
double double_drift(const Energies& energies, double step);

/// The drift of the total energy [kJ/mol/ps]. A drift of at most double_drift(), for example of
/// molecules without interactions, is set to 0.
double drift_rate(const EnergyStatistics& energies, double step);

/// The rms deviation of a random walk from its mean over a run. The walk is given by its variance
/// per time. With the variance `rate` per time, the mean square deviation from the first value is
/// rate t/2, and the variance of the mean is rate t/3. The difference gives √(rate t/6).
double walk_fluctuation(double rate, double length);

/// The rms deviation of the total energy from its mean that round-off causes in a run [kJ/mol]. The
/// contributions of the random walk and of the energy noise add: σ² = power² h t Σw²/6 + energy².
double rounding_fluctuation(const ForceNoise& noise, const NestedScheme& scheme, double lambda,
                            double step, double length);

/// Round-off dominates R if R is less than this multiple of its round-off limit. In this case, R is
/// at least 15 % larger than in double precision, because round-off and time-step errors add in
/// quadrature.
inline constexpr double rounding_margin = 2;

}  // namespace polhode
