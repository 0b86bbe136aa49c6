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

/// The total dipole M = Σ μ of molecules without net charge; for charged molecules M is not defined
/// in a periodic box.
class TotalDipole {
 public:
  explicit TotalDipole(const Topology& topology);
  /// @param error  of the step, at this state; nothing where it is not known
  void add(const State& state, const std::optional<StepError>& error = {});

  struct Result {
    SeriesEstimate constant;  ///< ε
    SeriesEstimate kirkwood;  ///< (⟨M²⟩ − ⟨M⟩²)/Σ μ², the Kirkwood g factor: 1 for uncorrelated
                              ///< dipoles
    Convergence convergence;   ///< of both
    double mean_over_rms = 0;  ///< |⟨M⟩|/√⟨M²⟩: small for a sufficiently long run
    std::vector<SeriesEstimate> stages;  ///< ε from the first block, the first two, and so on
    std::vector<double> frames;          ///< number of frames that each of these is based on
  };

  /// With g = (⟨M²⟩ − ⟨M⟩²)/(3 ε₀ V k_B T), (ε − 1)(2 ε' + 1)/(2 ε' + ε) = g for surroundings of
  /// permittivity ε': ε = 1 + g for tin foil; for a reaction field, ε' is that of the field
  /// [neumann1983]. ⟨M⟩² is about ⟨M²⟩ divided by the number of independent values of M: above a
  /// tenth of ⟨M²⟩ no error is given.
  /// @param interval  between frames [ps]; 0: they have no times
  Result result(double temperature, double surroundings_permittivity, double interval = 1) const;

  /// What the step changes in a result.
  struct StepBias {
    SeriesEstimate constant, kirkwood;
  };
  /// @param temperature  that of the result if it was given [K]; nothing: that of the samples,
  /// which
  ///                     the step changes as well
  StepBias step_bias(std::optional<double> temperature, double surroundings_permittivity,
                     double degrees_of_freedom, FixedMeans fixed) const;

 private:
  std::vector<Vec3<double>> dipole_;  // of each part, body frame
  std::vector<std::size_t> count_;
  double squares_ = 0;     // Σ μ²
  TimeBlocks blocks_;      // of M, M² and V
  StepResponse response_;  // of these and the kinetic energy
};

}  // namespace polhode
