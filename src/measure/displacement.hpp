// SPDX-License-Identifier: MIT
// Mean-square displacements of centres, and diffusion coefficients from them.
#pragma once

#include <cstddef>
#include <vector>

#include "measure/convergence.hpp"
#include "measure/time_correlation.hpp"
#include "polhode/base/workers.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// Unwraps trajectories: frames may hold centres wrapped into the box, so each centre is advanced
/// by the minimum image of its displacement since the previous frame.
class Unwrapped {
 public:
  /// Adds the next frame.
  void follow(const State& state);
  const Vec3Column& centres() const { return q_; }  ///< [nm]
  /// The largest displacement along one axis between two frames, relative to the box edge along
  /// that axis. A displacement of half an edge or more appears shorter than it is.
  double max_step() const { return max_step_; }

 private:
  Vec3Column q_, last_;
  double max_step_ = 0;
};

/// Largest relative displacement between two frames for which periodic images can still be
/// distinguished reliably: displacements are random, and those above half an edge are misassigned.
inline constexpr double safe_step = 0.25;

/// Displacements relative to the centre of mass of all bodies, because a common motion is not
/// diffusion. With zero total momentum the centre of mass is at rest, and nothing is subtracted.
class Displacement {
 public:
  Displacement(const Topology& topology, std::size_t lags);
  void add(const State& state, Workers& workers = Workers::serial());

  /// ⟨|q(t + lag) − q(t)|²⟩ [nm²] at each lag, of the bodies of one part of the topology; q is
  /// relative to the centre of mass of all bodies, so that a common velocity does not count as
  /// diffusion.
  BlockMeans mean_square(std::size_t part, Workers& workers = Workers::serial());
  double max_step() const { return unwrapped_.max_step(); }

 private:
  Bodies bodies_;
  Unwrapped unwrapped_;
  std::vector<TimeCorrelation> parts_;
};

/// Range of lags for a line fit [ps].
struct FitWindow {
  double from = 0, to = 0;
};

/// D = slope/6 of the mean-square displacement [nm²/ps], by a least-squares line through the lags
/// within the window (Einstein relation; allen2017, section 2.7). NaN if there are fewer than two.
/// No error is given for runs shorter than eight times the maximum lag.
/// @param interval  between lags [ps]
SeriesEstimate diffusion(const BlockMeans& squared_displacement, double interval,
                         const FitWindow& window);

/// The line of that fit at a lag [nm²]; there must be two lags within the window.
double fitted_displacement(const BlockMeans& squared_displacement, double interval,
                           const FitWindow& window, double lag);

/// Convergence of D: the run has `windows_of_lags` times the longest lag, and the slopes in the two
/// halves of the window do not differ, as they do while molecules are still in their cages.
Convergence diffusion_convergence(const BlockMeans& squared_displacement, double interval,
                                  const FitWindow& window);

/// Yeh-Hummer finite-size correction: the amount by which the periodic images lower the diffusion
/// coefficient in a cubic box [nm²/ps], ξ k_B T/(6 π η L) with ξ = 2.837297 [yeh2004, Eq. 12].
/// @param viscosity  of the liquid [u/(nm ps)]
double yeh_hummer_correction(double temperature, double viscosity, double edge);

}  // namespace polhode
