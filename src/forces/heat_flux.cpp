// SPDX-License-Identifier: MIT
#include "polhode/forces/heat_flux.hpp"

#include <algorithm>
#include <optional>

#include "forces/mesh/mesh_heat_flux.hpp"
#include "forces/pairs/pair_heat_flux.hpp"
#include "polhode/base/error.hpp"
#include "polhode/base/quaternion.hpp"

namespace polhode {
namespace {

const ForceSettings& checked(const Topology& topology, const ForceSettings& settings) {
  if (topology.parts.size() != 1)
    throw Error(
        "the heat flux is defined for one kind of molecule; in a mixture, it needs the partial "
        "enthalpies of all kinds");
  if (settings.external) throw Error("the heat flux does not include external forces");
  if (settings.slab_dispersion)
    throw Error("the heat flux does not include slab_dispersion; use dispersion_correction");
  if (settings.electrostatics == Electrostatics::pme && !settings.mesh)
    throw Error("the heat flux needs the mesh of PME: give the settings of a ForceField");
  return settings;
}

/// The distance of centres beyond which two molecules do not interact.
double range_of(const Topology& topology, const ForceSettings& settings) {
  const double cutoff = std::max(settings.cutoff, cutoff_of_charges(settings));
  if (cutoff_treatment(settings) == CutoffTreatment::molecule_switch) return cutoff;
  return cutoff + 2 * topology.parts.front().molecule.extent();
}

}  // namespace

struct HeatFlux::Parts {
  Box box;
  Bodies bodies;
  InteractionSites sites;
  PairTables tables;
  PairLaws<double> laws;
  CutoffTreatment treatment;
  double range, share;
  std::optional<MeshHeatFlux> mesh;
  Motion motion;

  void set_motion(const State& state) {
    motion.q = state.q;
    for (std::size_t i = 0; i < state.size(); ++i) {
      const Quaternion<double> a = state.orientation[i];
      motion.v.set(i, bodies.inverse_m[i] * state.p[i]);
      motion.omega.set(i, to_lab(a, scaled(bodies.inverse_J[i], to_body(a, state.ell[i]))));
      for (std::size_t k = 0; k < sites.size(); ++k)
        motion.arms[k].set(i, to_lab(a, sites.sites[k].r));
    }
  }
};

HeatFlux::HeatFlux(const Topology& topology, const ForceSettings& settings, const Box& box,
                   double share) {
  const ForceSettings& s = checked(topology, settings);
  const Molecule& molecule = topology.parts.front().molecule;
  parts_ = std::make_unique<Parts>(Parts{box, Bodies(topology), InteractionSites(molecule),
                                         PairTables(topology, s.mixing), PairLaws<double>(s),
                                         cutoff_treatment(s), range_of(topology, s), share,
                                         std::nullopt, Motion()});
  if (s.electrostatics == Electrostatics::pme) parts_->mesh.emplace(molecule, *s.mesh, box);
  const Vec3Column all(topology.size());
  parts_->motion = {all, all, all, std::vector<Vec3Column>(parts_->sites.size(), all)};
}

HeatFlux::HeatFlux(HeatFlux&&) noexcept = default;
HeatFlux::~HeatFlux() = default;

Vec3<double> HeatFlux::operator()(const State& state) {
  Parts& p = *parts_;
  if (state.box != p.box)
    throw Error("the heat flux was set up for another box; make a HeatFlux for each box");
  p.set_motion(state);
  Vec3<double> flux = POLHODE_CURRENT_LOOPS(pair_heat_flux)(
      {p.tables(0, 0), p.laws, p.treatment, p.motion, state.box.edge, p.range, p.share});
  for (std::size_t i = 0; i < state.size(); ++i) {
    const Vec3<double> v = p.motion.v[i];
    flux += (dot(state.p[i], v) + dot(state.ell[i], p.motion.omega[i])) / 2 * v;
  }
  if (p.mesh) flux += (*p.mesh)(p.motion);
  return flux;
}

}  // namespace polhode
