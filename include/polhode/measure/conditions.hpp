// SPDX-License-Identifier: MIT
// Mass density and kinetic temperature along a trajectory.
#pragma once

#include "polhode/measure/correlated_series.hpp"
#include "polhode/measure/energy.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// Averages that need no more than single frames.
class Conditions {
 public:
  explicit Conditions(const Topology& topology);
  void add(const State& state, bool has_velocities);

  SeriesEstimate density() const;      ///< [u/nm³]
  SeriesEstimate temperature() const;  ///< T of translation and rotation [K]; 0 without velocities
  SeriesEstimate volume() const;       ///< [nm³]
  /// Averages over blocks of time: density, temperature and volume.
  BlockMeans blocks() const { return blocks_.means(); }

 private:
  Bodies bodies_;
  double mass_;
  double degrees_of_freedom_;
  TimeBlocks blocks_;
};

}  // namespace polhode
