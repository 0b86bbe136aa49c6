// SPDX-License-Identifier: MIT
// Mean-square displacements of centres relative to the centre of mass of all bodies, and the
// diffusion coefficients that they tell.
#pragma once

#include <cstddef>
#include <vector>

#include "polhode/base/workers.hpp"
#include "polhode/measure/time_correlation.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// Centres followed through the walls of the box: frames may hold them wrapped into it, so each is
/// carried on by the minimum image of its way since the frame before.
class Unwrapped {
 public:
  /// The next frame.
  void follow(const State& state);
  const Vec3Column& centres() const { return q_; }  ///< [nm]
  /// The longest way along one axis between two frames, over the edge of the box along it. A way
  /// of half an edge or more looks shorter than it is.
  double longest_step() const { return longest_step_; }

 private:
  Vec3Column q_, last_;
  double longest_step_ = 0;
};

/// Beyond this part of an edge between two frames, images can no longer be told apart for sure:
/// ways spread by chance, and those of half an edge are lost.
inline constexpr double safe_step = 0.25;

class Displacement {
 public:
  Displacement(const Topology& topology, std::size_t lags);
  void add(const State& state, Workers& workers = Workers::serial());

  /// ⟨|q(t + lag) − q(t)|²⟩ [nm²] at each lag, of the bodies of one part of the topology; q
  /// relative to the centre of mass of all bodies, so that a common velocity is no diffusion.
  BlockMeans squared(std::size_t part, Workers& workers = Workers::serial());
  double longest_step() const { return unwrapped_.longest_step(); }

 private:
  Bodies bodies_;
  Unwrapped unwrapped_;
  std::vector<TimeCorrelation> parts_;
};

/// Lags that a line is fitted to [ps].
struct FitWindow {
  double from = 0, to = 0;
};

/// D = slope/6 of the mean-square displacement [nm²/ps], by a line of least squares through lags
/// within the window (Einstein's relation; allen2017, section 2.7). Not a number if fewer than two
/// lags lie there.
/// @param interval  between lags [ps]
Estimate diffusion(const BlockMeans& squared_displacement, double interval,
                   const FitWindow& window);

/// What the images of a body in a cubic box take from its diffusion [nm²/ps]: ξ k_B T/(6 π η L)
/// with ξ = 2.837297 (yeh2004, Eq. 12).
/// @param viscosity  of the liquid [u/(nm ps)]
double image_drag(double temperature, double viscosity, double edge);

}  // namespace polhode
