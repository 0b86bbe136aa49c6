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

/// The largest relative displacement between two frames for which periodic images can be
/// distinguished reliably. Displacements scatter, and a displacement above half an edge would be
/// assigned to the wrong image.
inline constexpr double safe_step = 0.25;

/// Computes displacements relative to the centre of mass of all bodies, because a common motion is
/// not diffusion. With zero total momentum the centre of mass is at rest, and nothing is
/// subtracted.
class Displacement {
 public:
  Displacement(const Topology& topology, std::size_t lags);
  void add(const State& state, Workers& workers = Workers::serial());

  /// The mean-square displacement ⟨|q(t + lag) − q(t)|²⟩ [nm²] at each lag, for the bodies of one
  /// part of the topology. q is relative to the centre of mass of all bodies, so that a common
  /// velocity does not contribute.
  BlockMeans mean_square(std::size_t part, Workers& workers = Workers::serial());
  /// The part of the mean-square displacement along one axis [nm²].
  BlockMeans mean_square_along(std::size_t axis, std::size_t part,
                               Workers& workers = Workers::serial());
  /// The largest displacement along an axis between two frames, relative to the box edge along that
  /// axis. A displacement of half an edge or more is underestimated.
  double max_step() const { return max_step_; }

 private:
  void follow(const State& state);

  Bodies bodies_;
  Vec3Column q_, last_;  // unwrapped centres, which are advanced by the minimum image of the
                         // displacement since the previous frame, and centres of this frame [nm]
  double max_step_ = 0;
  std::vector<TimeCorrelation> parts_;
};

/// A range of lags for the fit of a line [ps].
struct FitWindow {
  double from = 0, to = 0;
};

/// The diffusion coefficient D [nm²/ps]: a sixth of the slope of the mean-square displacement, from
/// a least-squares line through the lags within the window (Einstein relation; [allen2017, section
/// 2.7]). D is NaN if there are fewer than two lags. No error is given for runs shorter than eight
/// times the maximum lag.
/// @param interval  time between lags [ps]
SeriesEstimate diffusion(const BlockMeans& squared_displacement, double interval,
                         const FitWindow& window);

/// The diffusion coefficient along one axis: half of the slope of the mean-square displacement
/// along this axis.
inline SeriesEstimate diffusion_along(const BlockMeans& squared_displacement, double interval,
                                      const FitWindow& window) {
  return scaled(diffusion(squared_displacement, interval, window), 3);
}

/// The fitted line of diffusion() at a lag [nm²]. There must be at least two lags within the
/// window.
double fitted_displacement(const BlockMeans& squared_displacement, double interval,
                           const FitWindow& window, double lag);

/// The convergence of the diffusion coefficient. The run must be `windows_of_lags` times as long as
/// the longest lag. The slopes in the two halves of the window must not differ. The slopes differ
/// if the window contains lags at which molecules have not yet left the cages of their neighbours.
Convergence diffusion_convergence(const BlockMeans& squared_displacement, double interval,
                                  const FitWindow& window);

}  // namespace polhode
