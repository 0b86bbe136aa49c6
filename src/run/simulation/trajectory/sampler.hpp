// SPDX-License-Identifier: MIT
// The samples of a trajectory: energies, and at separate intervals configurational temperatures and
// the shadow energy.
#pragma once

#include <optional>

#include "blow_up.hpp"
#include "polhode/run/simulation/trajectory/trajectory.hpp"
#include "timed_integrator.hpp"

namespace polhode {

/// Takes samples of a system between two steps, and keeps their statistics.
class Sampler {
 public:
  /// Constructs the sampler; all arguments are kept by reference.
  Sampler(const System& system, const TrajectorySettings& settings, TimedIntegrator& integrator,
          const BlowUpReport& report, Workers& workers);

  /// Takes a sample of the current state, for the statistics and the watch.
  /// @param exchanged  heat and work received so far [kJ/mol]
  /// @throws BlowUp  if the energy is not finite, or has changed by more than is physically
  ///   possible
  void sample(std::size_t step, double exchanged, Clocks& clocks, const Watch& watch);

  bool empty() const { return statistics_.energies.samples == 0; }
  const TrajectoryStatistics& statistics() const { return statistics_; }
  void resume_from(const TrajectoryStatistics& statistics);

 private:
  /// A state as it is read, with its forces and energies: the present state, or a copy of it after
  /// a postprocessor.
  struct Reading {
    const State& state;
    const Load& load;
    Energies energies;
  };
  Reading read(std::size_t step, double exchanged, Clocks& clocks);
  bool due(double every) const;
  void sample_shadow(Reading& now, const Watch& watch);
  std::optional<StepError> error_of(const Energies& now) const;
  void sample_configurational(std::size_t step, const Reading& now,
                              const std::optional<StepError>& error);
  void sample_at_bath();
  void check_energy(std::size_t step, const Energies& now);

  const System& system_;
  const TrajectorySettings& settings_;
  TimedIntegrator& integrator_;
  const BlowUpReport& report_;
  Workers& workers_;
  State processed_;  ///< the copy that the postprocessor changes; not used without one
  ErrorTerms terms_;
  std::optional<FixedMeans> fixed_;
  double ideal_;  // ideal-gas term N kT [kJ/mol]
  TrajectoryStatistics statistics_;
  /// Energies of the last sample [kJ/mol]; empty if that sample was taken before the run was
  /// resumed.
  std::optional<double> conserved_, potential_;
};

}  // namespace polhode
