// SPDX-License-Identifier: MIT
#include "polhode/forces/heat_flux.hpp"

#include "forces/fluid_pairs.hpp"
#include "polhode/base/error.hpp"

namespace polhode {
namespace {

const ForceSettings& checked(const Topology& topology, const ForceSettings& settings) {
  if (topology.parts.size() != 1)
    throw Error(
        "the heat flux is defined for one kind of molecule; in a mixture, it needs the partial "
        "enthalpies of all kinds");
  if (settings.slab_dispersion)
    throw Error("the heat flux does not include slab_dispersion; use dispersion_correction");
  return settings;
}

}  // namespace

HeatFlux::HeatFlux(const Topology& topology, const ForceSettings& settings, const Box& box,
                   double share)
    : fluid_(std::make_unique<FluidPairs>(topology, checked(topology, settings), box,
                                          "the heat flux")),
      share_(share) {}

HeatFlux::HeatFlux(HeatFlux&&) noexcept = default;
HeatFlux::~HeatFlux() = default;

Vec3<double> HeatFlux::operator()(const State& state) {
  fluid_->set_motion(state);
  const Motion& motion = fluid_->motion;
  Vec3<double> flux = POLHODE_CURRENT_LOOPS(pair_heat_flux)(fluid_->job(share_));
  for (std::size_t i = 0; i < state.size(); ++i) {
    const Vec3<double> v = motion.v[i];
    flux += (dot(state.p[i], v) + dot(state.ell[i], motion.omega[i])) / 2 * v;
  }
  if (fluid_->mesh) flux += (*fluid_->mesh)(motion);
  return flux;
}

}  // namespace polhode
