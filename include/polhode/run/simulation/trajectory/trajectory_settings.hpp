// SPDX-License-Identifier: MIT
// Settings that determine a trajectory together with the system: scheme, step, length, and sampling
// intervals.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "polhode/integrate/error_terms.hpp"
#include "polhode/integrate/nested_scheme.hpp"
#include "polhode/io/settings/config.hpp"
#include "polhode/measure/step_bias.hpp"
#include "polhode/model/ensemble_settings.hpp"

namespace polhode {

struct TrajectorySettings {
  Scheme scheme;
  double step = 0;                     ///< time step [ps]
  double length = 0;                   ///< length of the trajectory [ps]
  double sample = 0;                   ///< time between energy samples [ps]; at least one step
  double lambda = 1e-4;                ///< λ of finite-difference gradients
  double shadow_sample = 0;            ///< time between samples of error brackets [ps]; 0: none
  std::optional<InnerScheme> inner{};  ///< inner scheme within the drifts of the scheme
  double configurational_sample = 0;   ///< time between samples of configurational temperatures
                                       ///< [ps]; 0: none
  std::uint64_t seed = 0;              ///< seed of the random signs of configurational temperatures
  double stretch = 0;           ///< length of the parts for which R is also computed [ps]; 0: none
  EnsembleSettings ensemble{};  ///< settings of the ensemble; the default is constant energy
  bool processed = false;       ///< whether samples are read through a postprocessor

  std::size_t steps() const { return steps_in(length); }
  /// The number of steps in a time [ps], rounded to the nearest integer. With hybrid Monte Carlo,
  /// the number is rounded up to whole trajectories.
  std::size_t steps_in(double time) const;
  std::size_t steps_per_trajectory() const;  ///< steps per trajectory of hybrid Monte Carlo, or 1
  std::size_t steps_per_move() const;        ///< number of steps per move of a barostat
  double move_interval() const;              ///< time of steps_per_move() [ps]
  std::size_t steps_per_sample() const;
  /// The number of energy samples between two samples of a quantity that is measured every
  /// `interval` [ps].
  std::size_t samples_per(double interval) const;

  /// Whether a shadow energy can be measured. The shadow energy differs from the energy by error
  /// brackets of order h². The shadow energy is conserved at constant energy. In other ensembles,
  /// the shadow energy gives the time-step bias.
  bool has_shadow() const;
  /// The prefactors of the O(h²) error in the states that are read.
  ErrorTerms error_terms() const;
  /// The means that the ensemble fixes when the time-step bias is predicted; empty if the bias is
  /// not known.
  std::optional<FixedMeans> fixed_means() const;
  /// Checks the settings of the shadow energy.
  /// @throws Error  if a shadow energy is requested for a scheme or ensemble that has none
  void check_shadow() const;
  /// Checks that the scheme has a postprocessor if samples are read through one.
  /// @throws Error  if no postprocessor is known, or if the ensemble excludes one
  void check_processed() const;
};

/// The trajectory of a run file.
/// @param stretch  length of the parts for which R is computed as well [ps]; 0: none
/// @throws Error  if the length is shorter than a step or has too many steps, or if a shadow energy
///   is requested for a scheme that has none
TrajectorySettings trajectory_settings(const Config& config, double stretch = 0);

}  // namespace polhode
