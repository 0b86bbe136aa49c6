// SPDX-License-Identifier: MIT
// What thermostat, barostat and hybrid Monte Carlo did in a run, for its report.
#pragma once

#include <cstdint>
#include <optional>

#include "polhode/run/simulation/trajectory/trajectory.hpp"

namespace polhode {

struct BarostatSummary {
  SeriesEstimate density;          ///< mean of M/V [u/nm³]
  SeriesEstimate volume;           ///< mean [nm³]
  SeriesEstimate compressibility;  ///< isothermal, (⟨V²⟩ − ⟨V⟩²)/(kT ⟨V⟩) [nm³ mol/kJ]
  Drift volume_drift;              ///< [nm³/ps]
  std::uint64_t moves = 0, accepted = 0;
  std::uint64_t evaluations = 0;   ///< number of force evaluations by moves
  double work = 0;                 ///< received by the bodies [kJ/mol]
  SeriesEstimate accepted_share;   ///< acceptance() with its standard error
  double interval = 0;             ///< time between two moves [ps]
  std::uint64_t beyond_shape = 0;  ///< moves rejected by max_shape_change
  double acceptance() const;
};

struct HybridMonteCarloSummary {
  std::uint64_t trajectories = 0, accepted = 0;
  SeriesEstimate weight;  ///< ⟨w⟩, w = exp(−ΔH/kT), which is 1 in the canonical distribution
  double work = 0;        ///< received by the bodies from draws and rejections [kJ/mol]
  SeriesEstimate accepted_share;  ///< acceptance() with its standard error
  /// Integrated autocorrelation time of the potential energy [ps], and the number of independent
  /// samples of it that the run is worth.
  SeriesEstimate correlation_time, effective_samples;
  SeriesEstimate bounded_weight;  ///< ⟨(w − 1) exp(−|ΔH|/kT)⟩, 0 in the canonical distribution
  double acceptance() const;
};

/// Empty at constant energy.
struct EnsembleSummary {
  EnsembleSettings settings;
  double heat = 0;  ///< received by the bodies from the thermostat [kJ/mol]
  std::optional<BarostatSummary> barostat;
  std::optional<HybridMonteCarloSummary> hybrid_monte_carlo;
};

EnsembleSummary ensemble_summary(const System& system, const TrajectorySettings& settings,
                                 const Trajectory& trajectory);

}  // namespace polhode
