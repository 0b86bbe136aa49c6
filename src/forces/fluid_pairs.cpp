// SPDX-License-Identifier: MIT
#include "forces/fluid_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "polhode/base/error.hpp"
#include "polhode/base/quaternion.hpp"

namespace polhode {
namespace {

void check(const Topology& topology, const ForceSettings& settings, std::string_view what) {
  if (topology.parts.size() != 1)
    throw Error(fmt::format("{} needs a fluid of one kind of molecule", what));
  if (settings.external) throw Error(fmt::format("{} does not include external forces", what));
  if (settings.electrostatics == Electrostatics::pme && !settings.mesh)
    throw Error(fmt::format("{} needs the mesh of PME: give the settings of a ForceField", what));
}

/// The distance of centres beyond which two molecules do not interact.
double range_of(const Topology& topology, const ForceSettings& settings) {
  const double cutoff = std::max(settings.cutoff, cutoff_of_charges(settings));
  if (cutoff_treatment(settings) == CutoffTreatment::molecule_switch) return cutoff;
  return cutoff + 2 * topology.parts.front().molecule.extent();
}

}  // namespace

FluidPairs::FluidPairs(const Topology& topology, const ForceSettings& settings,
                       const Box& box_of_all, std::string_view quantity)
    : what((check(topology, settings, quantity), quantity)),
      box(box_of_all),
      bodies(topology),
      sites(topology.parts.front().molecule),
      tables(topology, settings.mixing),
      laws(settings),
      treatment(cutoff_treatment(settings)),
      range(range_of(topology, settings)) {
  if (settings.electrostatics == Electrostatics::pme)
    mesh.emplace(topology.parts.front().molecule, *settings.mesh, box);
  const Vec3Column all(topology.size());
  motion = {all, all, all, std::vector<Vec3Column>(sites.size(), all)};
}

void FluidPairs::place(const State& state) {
  if (state.box != box)
    throw Error(fmt::format("{} was set up for another box; set it up for each box", what));
  motion.q = state.q;
  for (std::size_t i = 0; i < state.size(); ++i)
    for (std::size_t k = 0; k < sites.size(); ++k)
      motion.arms[k].set(i, to_lab(state.orientation[i], sites.sites[k].r));
}

void FluidPairs::set_motion(const State& state) {
  place(state);
  for (std::size_t i = 0; i < state.size(); ++i) {
    const Quaternion<double> a = state.orientation[i];
    motion.v.set(i, bodies.inverse_m[i] * state.p[i]);
    motion.omega.set(i, to_lab(a, scaled(bodies.inverse_J[i], to_body(a, state.ell[i]))));
  }
}

}  // namespace polhode
