// SPDX-License-Identifier: MIT
// Operations of a run in addition to the steps of the scheme: the bath, moves of the box, and the
// draws and decisions of hybrid Monte Carlo.
#pragma once

#include <optional>

#include "ensemble/thermostat.hpp"
#include "polhode/ensemble/barostat.hpp"
#include "polhode/ensemble/hybrid_monte_carlo.hpp"
#include "polhode/run/simulation/system/system.hpp"
#include "polhode/run/simulation/trajectory/trajectory.hpp"
#include "polhode/run/simulation/trajectory/trajectory_settings.hpp"

namespace polhode {

/// The thermostat, barostat and hybrid Monte Carlo of a run. A run at constant energy has none of
/// the three.
class EnsembleMoves {
 public:
  /// @param system, workers  kept by reference
  /// @throws Error  if the scheme is not suitable for the ensemble, see check_ensemble()
  EnsembleMoves(const System& system, const TrajectorySettings& settings, Workers& workers);
  EnsembleMoves(const EnsembleMoves&) = delete;
  EnsembleMoves& operator=(const EnsembleMoves&) = delete;

  /// The bath of the scheme, as a reference for an Integrator.
  struct Bath {
    EnsembleMoves* moves;
    void operator()(State& state, double t, StageNumber at) const;
  };
  Bath bath() { return {this}; }

  /// Whether energies are required after step number `steps` (the first step is 1).
  bool due(std::size_t steps) const { return decides(steps) || moves_box(steps); }

  /// Draws new momenta if a trajectory of hybrid Monte Carlo begins with the next step.
  /// @param load  function that returns the forces and energies of the state
  template <class LoadOf>
  void before_step(State& state, std::size_t steps, const LoadOf& load) {
    if (hybrid_ && steps % hybrid_->steps() == 0) hybrid_->begin(state, load(), steps);
  }

  /// Performs the operations after a step for which due() was true.
  /// @param load  load of the state, with energies; updated to the new state
  /// @return  whether positions or the box have changed
  bool after_step(State& state, std::size_t steps, Load& load, const Barostat::Evaluate& evaluate);

  EnsembleMemory memory() const;
  void resume_from(const EnsembleMemory& memory);
  double exchanged() const { return memory().exchanged(); }

 private:
  bool decides(std::size_t steps) const { return hybrid_ && steps % hybrid_->steps() == 0; }
  bool moves_box(std::size_t steps) const { return barostat_ && steps % steps_per_move_ == 0; }

  std::optional<Thermostat> thermostat_;
  std::optional<Barostat> barostat_;
  std::optional<HybridMonteCarlo> hybrid_;
  std::size_t steps_per_move_ = 0;
};

/// Checks the ensemble.
/// @throws Error  unless thermostat, barostat and hybrid Monte Carlo can be combined with each
///   other and with the scheme
void check_ensemble(const TrajectorySettings& settings);

}  // namespace polhode
