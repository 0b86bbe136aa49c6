// SPDX-License-Identifier: MIT
// The dielectric constant from fluctuations of the total dipole.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "measure/convergence.hpp"
#include "polhode/measure/step_response.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// The permittivity of the surroundings at infinity for PME as used here: a conductor ("tin foil").
inline constexpr double tin_foil = std::numeric_limits<double>::infinity();

/// The total dipole moment M = Σ μ in the lab frame [e nm].
Vec3<double> total_dipole(const State& state, const Topology& topology);

/// Collects the total dipole moment of molecules without a net charge. For charged
/// molecules, M is not defined in a periodic box.
class TotalDipole {
 public:
  explicit TotalDipole(const Topology& topology);
  /// Adds a sample.
  /// @param error  time-step error of this state; empty if it is not known
  void add(const State& state, const std::optional<StepError>& error = {});

  struct Result {
    SeriesEstimate constant;  ///< dielectric constant ε
    SeriesEstimate kirkwood;  ///< Kirkwood g factor (⟨M²⟩ − ⟨M⟩²)/Σ μ²; 1 for uncorrelated dipoles
    Convergence convergence;  ///< convergence of both quantities
    double mean_over_rms = 0;  ///< ratio |⟨M⟩|/√⟨M²⟩, which is small for a sufficiently long run
    std::vector<SeriesEstimate> stages;  ///< ε from the first block, from the first two blocks, and
                                         ///< so on up to the whole run
    std::vector<double> frames;  ///< number of frames for each element of `stages`
  };

  /// Computes the dielectric constant ε. With g = (⟨M²⟩ − ⟨M⟩²)/(3 ε₀ V k_B T) and surroundings of
  /// permittivity ε', (ε − 1)(2 ε' + 1)/(2 ε' + ε) = g [neumann1983]. For tin foil, ε = 1 + g. For
  /// a reaction field, ε' is the permittivity of the field. ⟨M⟩² is about ⟨M²⟩ divided by the
  /// number of independent values of M. If ⟨M⟩² is above 10 % of ⟨M²⟩, no error is given.
  /// @param interval  time between frames [ps]; 0 if frames have no times
  Result result(double temperature, double surroundings_permittivity, double interval = 1) const;

  /// The time-step bias of a result.
  struct StepBias {
    SeriesEstimate constant, kirkwood;
  };
  /// Computes the time-step bias.
  /// @param temperature  given temperature of the result [K]; if empty, the temperature of the
  ///   samples, which also has a time-step bias
  StepBias step_bias(std::optional<double> temperature, double surroundings_permittivity,
                     double degrees_of_freedom, FixedMeans fixed) const;

 private:
  Topology topology_;
  double squares_ = 0;     // sum of squared dipole moments Σ μ²
  TimeBlocks blocks_;      // blocks of M, M² and V
  StepResponse response_;  // time-step response of these and of the kinetic energy
};

}  // namespace polhode
