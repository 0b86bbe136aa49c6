// SPDX-License-Identifier: MIT
#include "run/simulation/system/near_forces.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "base/stopwatch.hpp"
#include "polhode/base/error.hpp"

namespace polhode {

ForceSettings near_settings(const ForceSettings& whole, const InnerScheme& inner) {
  if (inner.cutoff > whole.cutoff)
    throw Error(
        fmt::format("the cutoff of the near forces, {:g} nm, exceeds the cutoff of all forces, "
                    "{:g} nm; use a shorter cutoff of the near forces, for example 0.5 nm",
                    inner.cutoff, whole.cutoff));
  ForceSettings near = whole;
  near.truncation = Truncation::molecule_switch;
  near.electrostatics = Electrostatics::coulomb;
  near.mesh.reset();
  near.coulomb_cutoff.reset();
  near.dispersion_correction = near.slab_dispersion = false;
  near.external.reset();  // external forces vary slowly, so only the outer scheme evaluates them
  near.switch_from = inner.switch_from;
  near.cutoff = inner.cutoff;
  return near;
}

void check_near(const ForceSettings& whole, const NestedScheme& scheme, const std::string& place) {
  if (scheme.inner) at_place(place, [&] { near_settings(whole, *scheme.inner); });
}

double near_weight(const System& system, const std::optional<InnerScheme>& inner) {
  if (!inner) return 0;
  constexpr int repeats = 25;
  const State& state = system.state;
  ForceField whole(system.topology, system.forces, state.box);
  ForceField near(system.topology, near_settings(system.forces, *inner), state.box);
  Load load(state.size());
  const auto seconds = [&](ForceField& forces) {
    return seconds_of([&] { forces.forces_alone(state, load); });
  };
  double min_full = std::numeric_limits<double>::infinity(), min_near = min_full;
  for (int k = 0; k < repeats; ++k) {  // the first pass builds the neighbour lists
    min_full = std::min(min_full, seconds(whole));
    min_near = std::min(min_near, seconds(near));
  }
  return min_near / min_full;
}

}  // namespace polhode
