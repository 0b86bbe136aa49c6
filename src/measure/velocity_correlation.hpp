// SPDX-License-Identifier: MIT
// Velocity autocorrelation functions, with spectra and diffusion coefficients.
#pragma once

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

  /// The velocity autocorrelation function ⟨v(t) · v(t + lag)⟩/3 [nm²/ps²] of the bodies' centres
  /// in a part of the topology, relative to the centre of mass of all bodies.
  BlockMeans linear(std::size_t part, Workers& workers = Workers::serial());

  /// The angular velocity autocorrelation function ⟨ω_k(t) ω_k(t + lag)⟩ [1/ps²] about a principal
  /// axis fixed in the body. For a linear body the function is ⟨ω(t) · ω(t + lag)⟩/2 in the lab
  /// frame. The atoms of a frame do not determine the rotation of a linear body about its axis. The
  /// directions of the two axes normal to the molecule are therefore not known either.
  BlockMeans angular(std::size_t part, std::size_t axis, Workers& workers = Workers::serial());

  /// The principal axes with a nonzero moment of inertia, because only these axes have an angular
  /// velocity. For a linear body, one of the two equivalent axes represents both.
  std::vector<std::size_t> turning_axes(std::size_t part) const;
  /// Whether the molecules of a part are linear.
  bool linear_body(std::size_t part) const;

 private:
  Bodies bodies_;
  std::vector<Molecule> molecules_;
  std::vector<TimeCorrelation> linear_, angular_;
};

/// The running integral ∫₀^t C dt' at each lag, by the trapezoidal rule. Once C has decayed, the
/// running integral is the Green-Kubo diffusion coefficient [nm²/ps] [allen2017, section 2.7].
BlockMeans running_integral(const BlockMeans& correlation, double interval);

/// The convergence of the running integral at the last lag. The run must be `windows_of_lags` times
/// as long as the last lag. The integrals up to the last lag and up to half of the last lag must
/// agree, and the trapezoidal rule must be accurate. The error of the trapezoidal rule is a third
/// of the change when its interval is doubled (Richardson). The error is smaller if C is smooth at
/// lag 0, as in dynamics without friction.
Convergence integral_convergence(const BlockMeans& correlation, double interval);

/// The normalized function C(t)/C(0), which is exactly 1 at lag 0. If C(0) vanishes, the result is
/// C without normalization.
BlockMeans normalized(const BlockMeans& correlation);

struct Spectrum {
  std::vector<double> frequency;          ///< frequencies [1/ps]
  std::vector<SeriesEstimate> intensity;  ///< intensities [ps]
};

/// The spectrum I(ν) = 4 ∫₀^T Ĉ(t) w(t) cos(2πνt) dt with Ĉ = C/C(0) and the Hann window w =
/// cos²(πt/2T). The window avoids truncation ripples and broadens lines to about 1/T. The integral
/// ∫ I dν over ν > 0 is 1.
Spectrum spectrum(const BlockMeans& correlation, double interval);

}  // namespace polhode
