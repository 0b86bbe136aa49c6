// SPDX-License-Identifier: MIT
// Mass density and kinetic temperature along a trajectory.
#pragma once

#include "polhode/measure/correlated_series.hpp"
#include "polhode/measure/energy.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// Averages of density, temperature and volume over frames. A single frame determines each of these
/// quantities.
class Conditions {
 public:
  explicit Conditions(const Topology& topology);
  void add(const State& state, bool has_velocities);

  SeriesEstimate density() const;      ///< Mean density [u/nm³] with its standard error.
  SeriesEstimate temperature() const;  ///< Mean temperature of translation and rotation [K], over
                                       ///< frames with velocities; 0 if there are none.
  SeriesEstimate volume() const;       ///< Mean volume [nm³] with its standard error.
  /// Sums of density, temperature, volume and number of frames with velocities, in blocks of time.
  BlockMeans blocks() const { return blocks_.means(); }

 private:
  Bodies bodies_;
  double mass_;
  double degrees_of_freedom_;
  TimeBlocks blocks_;
};

}  // namespace polhode
