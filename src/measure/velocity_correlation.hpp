// SPDX-License-Identifier: MIT
// Velocity autocorrelation functions, their spectra, and diffusion coefficients from them.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "measure/convergence.hpp"
#include "measure/time_correlation.hpp"
#include "polhode/base/workers.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

class VelocityCorrelation {
 public:
  VelocityCorrelation(const Topology& topology, std::size_t lags);
  void add(const State& state, Workers& workers = Workers::serial());

  /// ⟨v(t) · v(t + lag)⟩/3 of the centres of mass [nm²/ps²], relative to that of all bodies, for
  /// the bodies of one part.
  BlockMeans linear(std::size_t part, Workers& workers = Workers::serial());

  /// ⟨ω_k(t) ω_k(t + lag)⟩ [1/ps²] about a principal axis fixed in the body. Of a linear body
  /// ⟨ω(t) · ω(t + lag)⟩/2 in the lab frame: the atoms of a frame do not determine its rotation
  /// about its own axis, and with it the directions of the other two.
  BlockMeans angular(std::size_t part, std::size_t axis, Workers& workers = Workers::serial());

  /// Principal axes with nonzero moment of inertia: only these have an angular velocity. One of
  /// them stands for both of a linear body.
  std::vector<std::size_t> turning_axes(std::size_t part) const;
  /// Whether the angular velocity of a part is that of a linear body.
  bool linear_body(std::size_t part) const;

 private:
  Bodies bodies_;
  std::vector<Molecule> molecules_;
  std::vector<TimeCorrelation> linear_, angular_;
};

/// ∫₀^t C dt' at each lag by the trapezoidal rule: the Green-Kubo diffusion coefficient [nm²/ps]
/// once C has decayed [allen2017, section 2.7].
BlockMeans running_integral(const BlockMeans& correlation, double interval);

/// Convergence of its value at the last lag: the run has `windows_of_lags` times that lag, the
/// integral does not differ from that up to half of it, and the trapezoidal rule is accurate. The
/// error of the rule is a third of what its interval doubled changes (Richardson), and less where C
/// is smooth at lag 0, as it is without friction.
Convergence integral_convergence(const BlockMeans& correlation, double interval);

/// C(t)/C(0): 1 at lag 0, without an error. C itself if C(0) vanishes.
BlockMeans normalized(const BlockMeans& correlation);

struct Spectrum {
  std::vector<double> frequency;          ///< [1/ps]
  std::vector<SeriesEstimate> intensity;  ///< [ps]
};

/// I(ν) = 4 ∫₀^T Ĉ(t) w(t) cos(2πνt) dt with Ĉ = C/C(0) and the Hann window w = cos²(πt/2T), which
/// avoids truncation ripples and broadens lines to about 1/T. Then ∫ I dν = 1 over ν > 0.
Spectrum spectrum(const BlockMeans& correlation, double interval);

}  // namespace polhode
