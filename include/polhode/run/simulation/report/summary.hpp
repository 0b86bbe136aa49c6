// SPDX-License-Identifier: MIT
// What a run reports at its end.
#pragma once

#include <array>
#include <optional>

#include "polhode/run/simulation/report/ensemble_summary.hpp"
#include "polhode/run/simulation/report/rounding.hpp"
#include "polhode/run/simulation/trajectory/trajectory.hpp"

namespace polhode {

/// Fewer samples give neither a fluctuation nor a slope.
inline constexpr std::uint64_t min_samples_reported = 3;

/// Results of the present segment, which is the whole run unless something was changed.
struct RunSummary {
  std::size_t molecules = 0;
  Segment segment;
  std::size_t steps = 0;
  double length = 0;          ///< simulated [ps]
  double sample = 0;          ///< time between energies [ps]
  std::uint64_t samples = 0;  ///< number of samples of the energies
  /// R; not finite if the potential energy is constant. R and energy drift are not defined with
  /// hybrid Monte Carlo, because draws and rejections conserve no energy.
  SeriesEstimate ratio;
  SeriesEstimate total_fluctuation;      ///< rms of the conserved energy [kJ/mol]; as R not defined
  SeriesEstimate potential_fluctuation;  ///< rms [kJ/mol]
  double rounding = 0;                   ///< R of rounding alone, estimated; 0 in double precision
  double truncation = 0;                 ///< R of the walk that the truncation drives, predicted
  bool walk_known = true;  ///< false: mixed precision, and too large for its noise to be estimated
  Drift drift;             ///< drift of the conserved energy [kJ/mol/ps]
  /// Variance per time of the random walk of the conserved energy, without rounding in mixed
  /// precision [(kJ/mol)²/ps]; 0 unless there is clear evidence for one.
  double walk = 0;
  std::optional<ShadowSummary> shadow;                           ///< shadow energy, if requested
  std::optional<StepBias> step_bias;                             ///< nothing where it is not known
  ByMotion<std::optional<SeriesEstimate>> configurational;       ///< temperatures [K], if requested
  ByMotion<std::optional<SeriesEstimate>> configurational_bias;  ///< their time-step bias [K]
  SeriesEstimate potential;                                      ///< mean per molecule [kJ/mol]
  SeriesEstimate total;                                          ///< mean per molecule [kJ/mol]
  SeriesEstimate pressure;                                       ///< mean [kJ/mol/nm³]
  double momentum = 0;                                           ///< |Σ p| at the end [u nm/ps]
  TemperatureEstimates temperatures;                             ///< means over the run [K]
  /// Temperatures where a bath within the steps acts [K]; nothing without such a bath.
  std::optional<TemperatureEstimates> temperatures_at_bath;
  Drift potential_drift;  ///< [kJ/mol/ps]
  DegreesOfFreedom degrees_of_freedom;
  EnsembleSummary ensemble;
  std::uint64_t force_evaluations = 0, derivatives = 0, measurements = 0;
  std::uint64_t minimisation_evaluations = 0;                ///< evaluations before the run
  std::uint64_t near_evaluations = 0, near_derivatives = 0;  ///< evaluations of near forces, if any
  std::size_t list_rebuilds = 0;
  Timings timings;
  double ns_per_day = 0;

  /// The change of the conserved energy by its drift over the run, divided by the rms fluctuation
  /// of the potential energy, without sign; 0 if that is constant.
  double relative_drift() const;
  /// R of the random walk in a run of this length.
  double ratio_of_walk() const;
};

/// @param noise  of the forces at the start; none in double precision
RunSummary summary(const System& system, const TrajectorySettings& settings,
                   const Trajectory& trajectory, const ForceNoise& noise = {});

}  // namespace polhode
