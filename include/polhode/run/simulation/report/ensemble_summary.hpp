// SPDX-License-Identifier: MIT
// Results of the thermostat, barostat and hybrid Monte Carlo of a run, for its report.
#pragma once

#include <cstdint>
#include <optional>

#include "polhode/run/simulation/trajectory/trajectory.hpp"

namespace polhode {

struct BarostatSummary {
  SeriesEstimate density;          ///< mean density M/V [u/nm³]
  SeriesEstimate volume;           ///< mean volume [nm³]
  SeriesEstimate compressibility;  ///< isothermal compressibility (⟨V²⟩ − ⟨V⟩²)/(kT ⟨V⟩)
                                   ///< [nm³ mol/kJ]
  Drift volume_drift;  ///< drift of the volume [nm³/ps]
  std::uint64_t moves = 0, accepted = 0;
  std::uint64_t evaluations = 0;   ///< number of force evaluations by barostat moves
  double work = 0;                 ///< work done on the bodies [kJ/mol]
  SeriesEstimate accepted_share;   ///< acceptance rate with its standard error
  double interval = 0;             ///< time between two moves [ps]
  std::uint64_t beyond_shape = 0;  ///< moves rejected by max_shape_change
  double acceptance() const;
};

struct HybridMonteCarloSummary {
  std::uint64_t trajectories = 0, accepted = 0;
  SeriesEstimate weight;  ///< mean weight ⟨w⟩ with w = exp(−ΔH/kT), which is 1 in the canonical
                          ///< distribution
  double work = 0;  ///< energy given to the bodies by new momenta and rejections [kJ/mol]
  SeriesEstimate accepted_share;  ///< acceptance rate with its standard error
  /// Integrated autocorrelation time of the potential energy [ps], and the effective number of
  /// independent samples.
  SeriesEstimate correlation_time, effective_samples;
  SeriesEstimate bounded_weight;  ///< mean of (w − 1) exp(−|ΔH|/kT), which is 0 in the canonical
                                  ///< distribution
  double acceptance() const;
};

/// Results of the thermostat, barostat and hybrid Monte Carlo of a run; empty at constant energy.
struct EnsembleSummary {
  EnsembleSettings settings;
  double heat = 0;  ///< heat that the bodies have received from the thermostat [kJ/mol]
  std::optional<BarostatSummary> barostat;
  std::optional<HybridMonteCarloSummary> hybrid_monte_carlo;
};

EnsembleSummary ensemble_summary(const System& system, const TrajectorySettings& settings,
                                 const Trajectory& trajectory);

}  // namespace polhode
