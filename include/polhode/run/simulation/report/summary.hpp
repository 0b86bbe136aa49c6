// SPDX-License-Identifier: MIT
// The summary of results that a run reports at its end.
#pragma once

#include <optional>

#include "polhode/run/simulation/report/ensemble_summary.hpp"
#include "polhode/run/simulation/report/rounding.hpp"
#include "polhode/run/simulation/trajectory/trajectory.hpp"

namespace polhode {

/// The smallest number of samples from which fluctuations and slopes are reported.
inline constexpr std::uint64_t min_samples_reported = 3;

/// Results of the present segment of a trajectory. The segment is the whole run unless settings or
/// the state were changed.
struct RunSummary {
  std::size_t molecules = 0;
  Segment segment;
  std::size_t steps = 0;
  double length = 0;          ///< simulated time [ps]
  double sample = 0;          ///< time between energies [ps]
  std::uint64_t samples = 0;  ///< number of samples of the energies
  /// The ratio R; not finite if the potential energy is constant. With hybrid Monte Carlo, R and
  /// the energy drift are not defined, because new momenta and rejections change all energies.
  SeriesEstimate ratio;
  SeriesEstimate total_fluctuation;      ///< rms deviation of the conserved energy [kJ/mol]; not
                                         ///< defined if R is not defined
  SeriesEstimate potential_fluctuation;  ///< rms deviation of the potential energy [kJ/mol]
  double rounding = 0;                   ///< estimate of R if round-off were the only error; 0 in
                                         ///< double precision
  double truncation = 0;                 ///< predicted R if the only error is the random walk
                                         ///< caused by the truncation of forces
  bool walk_known = true;  ///< false in mixed precision if the system is too large for an estimate
                           ///< of its noise
  Drift drift;             ///< drift of the conserved energy [kJ/mol/ps]
  /// Random walk of the conserved energy, as a variance per time [(kJ/mol)²/ps], without
  /// mixed-precision round-off. The random walk is 0 unless there is clear evidence for it.
  double walk = 0;
  std::optional<ShadowSummary> shadow;  ///< results from the shadow energy, if requested
  std::optional<StepBias> step_bias;    ///< time-step bias; empty if it is not known
  ByMotion<std::optional<SeriesEstimate>> configurational;  ///< configurational temperatures [K],
                                                            ///< if requested
  ByMotion<std::optional<SeriesEstimate>>
      configurational_bias;           ///< time-step bias of configurational
                                      ///< temperatures [K]
  SeriesEstimate potential;           ///< mean potential energy per molecule [kJ/mol]
  SeriesEstimate total;               ///< mean total energy per molecule [kJ/mol]
  SeriesEstimate pressure;            ///< mean pressure [kJ/mol/nm³]
  double momentum = 0;                ///< total momentum |Σ p| at the end [u nm/ps]
  TemperatureEstimates temperatures;  ///< mean temperatures over the run [K]
  /// Temperatures of the momenta at the bath, if a scheme has the bath within its steps [K];
  /// otherwise empty.
  std::optional<TemperatureEstimates> temperatures_at_bath;
  Drift potential_drift;  ///< drift of the potential energy [kJ/mol/ps]
  /// Time [ps] after which the potential energy and the volume are stationary.
  double equilibrium_start = 0;
  DegreesOfFreedom degrees_of_freedom;
  EnsembleSummary ensemble;
  std::uint64_t force_evaluations = 0, derivatives = 0, measurements = 0;
  std::uint64_t minimisation_evaluations = 0;                ///< force evaluations before the run
  std::uint64_t near_evaluations = 0, near_derivatives = 0;  ///< numbers of evaluations and
                                                             ///< derivatives of near forces
  std::size_t list_rebuilds = 0;
  Timings timings;
  double ns_per_day = 0;

  /// The magnitude of the energy change that the drift of the conserved energy causes over the run,
  /// divided by the rms fluctuation of the potential energy. The result is 0 if the potential
  /// energy is constant.
  double relative_drift() const;
  /// The ratio R that the random walk causes in a run of this length.
  double ratio_of_walk() const;
};

/// Computes the summary of a trajectory.
/// @param noise  noise of the forces at the start; 0 in double precision
RunSummary summary(const System& system, const TrajectorySettings& settings,
                   const Trajectory& trajectory, const ForceNoise& noise = {});

}  // namespace polhode
