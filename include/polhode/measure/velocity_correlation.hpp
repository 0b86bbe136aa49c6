// SPDX-License-Identifier: MIT
// How bodies forget their velocities: autocorrelations, their spectra, and diffusion from them.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "polhode/base/workers.hpp"
#include "polhode/measure/time_correlation.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

class VelocityCorrelation {
 public:
  VelocityCorrelation(const Topology& topology, std::size_t lags);
  void add(const State& state, Workers& workers = Workers::serial());

  /// ⟨v(t) · v(t + lag)⟩/3 of bodies' centres, relative to the centre of mass of all bodies
  /// [nm²/ps²], of one part.
  BlockMeans linear(std::size_t part, Workers& workers = Workers::serial());

  /// ⟨ω_k(t) ω_k(t + lag)⟩ [1/ps²] about a principal axis that turns with the body.
  BlockMeans angular(std::size_t part, std::size_t axis, Workers& workers = Workers::serial());

  /// Principal axes with inertia: only there is an angular velocity.
  std::vector<std::size_t> turning_axes(std::size_t part) const;

 private:
  Bodies bodies_;
  std::vector<Molecule> molecules_;
  std::vector<TimeCorrelation> linear_, angular_;
};

/// ∫₀^t C dt' at each lag by trapezia: the diffusion coefficient of Green and Kubo [nm²/ps], once C
/// has decayed [allen2017, section 2.7].
BlockMeans running_integral(const BlockMeans& correlation, double interval);

struct Spectrum {
  std::vector<double> frequency;    ///< [1/ps]
  std::vector<Estimate> intensity;  ///< [ps]
};

/// I(ν) = 4 ∫₀^T Ĉ(t) w(t) cos(2πνt) dt with Ĉ = C/C(0) and Hann's window w = cos²(πt/2T), which
/// avoids the ripples of a sudden end and widens lines to about 1/T. Then ∫ I dν = 1 over ν > 0.
Spectrum spectrum(const BlockMeans& correlation, double interval);

}  // namespace polhode
