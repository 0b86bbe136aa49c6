// SPDX-License-Identifier: MIT
// Signs that a state point is not a liquid: a vapour, two phases, or a solid.
#pragma once

#include "polhode/model/state.hpp"
#include "run/properties/replica.hpp"

namespace polhode {

/// The structure factor of the centres at the three longest wavelengths of the box, averaged over
/// samples. It is of the order of one in a homogeneous fluid, and of the order of the number of
/// molecules if a part of the box is vapour.
class LongestWaves {
 public:
  void add(const State& state);
  double mean() const { return samples_ > 0 ? sum_ / samples_ : 0; }

 private:
  double sum_ = 0, samples_ = 0;
};

/// Checks that the density of a state point at constant volume can be the density of a liquid.
/// @param liquid  estimated density of the liquid [u/nm³]
/// @throws Error  if it is too low or too high
void check_density(double liquid, const StatePoint& at);

/// Checks that a system at constant pressure has not evaporated.
/// @throws RunError  if the density is too low for a liquid
void check_liquid(const State& state, double mass, const ReplicaSettings& settings);

/// Checks that the molecules have not separated into two phases.
/// @throws RunError  if they have
void check_one_phase(const LongestWaves& waves, std::size_t molecules, const StatePoint& at);

/// Checks that the molecules move as in a liquid.
/// @param start  positions at an earlier time, in fractions of the edges
/// @param time   time since then [ps]
/// @throws RunError  if they have moved by less than a quarter of their spacing. The message says
///   whether the system is a solid, or the time too short to tell
void check_motion(const State& state, const Bodies& bodies, const Vec3Column& start, double time,
                  const StatePoint& at);

/// Positions in fractions of the edges.
Vec3Column in_fractions(const State& state);

}  // namespace polhode
