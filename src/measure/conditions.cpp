// SPDX-License-Identifier: MIT
#include "polhode/measure/conditions.hpp"

#include <array>

namespace polhode {

Conditions::Conditions(const Topology& topology)
    : bodies_(topology),
      mass_(topology.mass()),
      degrees_of_freedom_(degrees_of_freedom(topology).all()) {}

void Conditions::add(const State& state, bool has_velocities) {
  const double kinetic = has_velocities ? energies(state, bodies_, Load{}).kinetic() : 0;
  const double volume = state.box.volume();
  blocks_.add(std::array{mass_ / volume, polhode::temperature(kinetic, degrees_of_freedom_), volume,
                         has_velocities ? 1.0 : 0.0});
}

SeriesEstimate Conditions::density() const { return series_estimates(blocks_.means())[0]; }
SeriesEstimate Conditions::temperature() const {
  const BlockMeans means = blocks_.means();
  const double share = means.mean()[3];  // of frames with velocities
  if (share == 0 || share == 1) return series_estimates(means)[1];
  return series_estimate(means, [](auto mean) { return mean[1] / mean[3]; });
}
SeriesEstimate Conditions::volume() const { return series_estimates(blocks_.means())[2]; }

}  // namespace polhode
