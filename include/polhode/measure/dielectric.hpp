// SPDX-License-Identifier: MIT
// The dielectric constant from fluctuations of the total dipole.
#pragma once

#include <limits>
#include <vector>

#include "polhode/measure/block_means.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// The permittivity of what surrounds the system at infinity with Ewald's sum as it is used here:
/// a conductor, "tin foil".
inline constexpr double tin_foil = std::numeric_limits<double>::infinity();

/// The total dipole M = Σ μ of molecules without net charge: of no other does M have a meaning in a
/// periodic box.
class TotalDipole {
 public:
  explicit TotalDipole(const Topology& topology);
  void add(const State& state);

  struct Result {
    Estimate constant;  ///< ε
    Estimate kirkwood;  ///< (⟨M²⟩ − ⟨M⟩²)/Σ μ²: 1 if dipoles do not know of each other
    double mean_over_rms = 0;    ///< |⟨M⟩|/√⟨M²⟩: small once the run is long enough
    std::vector<double> stages;  ///< ε of the first block, of the first two, and so on
    std::vector<double> frames;  ///< that these are from
  };

  /// With g = (⟨M²⟩ − ⟨M⟩²)/(3 ε₀ V k_B T), (ε − 1)(2 ε' + 1)/(2 ε' + ε) = g for a surrounding of
  /// permittivity ε': ε = 1 + g in tin foil, and for a reaction field its own ε' [neumann1983].
  Result result(double temperature, double surrounding) const;

 private:
  std::vector<Vec3<double>> dipole_;  // of each part, body frame
  std::vector<std::size_t> count_;
  double squares_ = 0;  // Σ μ²
  TimeBlocks blocks_;   // of M, M² and V
};

}  // namespace polhode
