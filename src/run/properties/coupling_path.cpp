// SPDX-License-Identifier: MIT
#include "run/properties/coupling_path.hpp"

#include <algorithm>

namespace polhode {
namespace {

/// The molecule with its potentials and charges as in a stage.
Molecule at_stage(Molecule molecule, const CouplingStage& stage) {
  for (Site& site : molecule.sites) {
    site.charge *= stage.charge;
    if (stage.size > 0) {
      site.size = stage.size;
    } else {
      site.epsilon = 0;
      site.law = LennardJonesLaw{};
    }
  }
  return molecule;
}

/// Whether a site that a pair of sites names has a short-range potential.
bool has_site(const Topology& topology, const std::string& name) {
  return std::ranges::any_of(topology.parts, [&](const auto& part) {
    return std::ranges::any_of(part.molecule.sites, [&](const Site& site) {
      return site.has_short_range() && part.molecule.name + '.' + site.name == name;
    });
  });
}

bool is_charged(const Molecule& molecule) {
  return std::ranges::any_of(molecule.sites, [](const Site& site) { return site.charge != 0; });
}
bool has_charges(const Topology& topology) {
  return std::ranges::any_of(topology.parts,
                             [](const auto& part) { return is_charged(part.molecule); });
}

}  // namespace

CouplingPath possible_stages(const Molecule& molecule) {
  constexpr int sizes = 32, charges = 16, first_size = 6;
  CouplingPath all{{}};
  for (int k = first_size; k <= sizes; ++k) all.push_back({k / static_cast<double>(sizes), 0});
  if (is_charged(molecule))
    for (int k = 1; k <= charges; ++k) all.push_back({1, k / static_cast<double>(charges)});
  return all;
}

System coupled(const System& whole, const CouplingStage& stage) {
  System system = whole;
  std::vector<Topology::Part>& parts = system.topology.parts;
  parts.insert(parts.begin() + 1, {at_stage(parts.front().molecule, stage), 1});
  if (--parts.front().count == 0) parts.erase(parts.begin());
  system.bodies = Bodies(system.topology);
  std::erase_if(system.forces.mixing.pairs, [&](const PairOverride& pair) {
    return !has_site(system.topology, pair.first) || !has_site(system.topology, pair.second);
  });
  if (!has_charges(system.topology)) {  // a mesh would have nothing to compute
    system.forces.electrostatics = Electrostatics::coulomb;
    system.forces.mesh.reset();
    system.forces.coulomb_cutoff.reset();
  }
  return system;
}

}  // namespace polhode
