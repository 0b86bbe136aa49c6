// SPDX-License-Identifier: MIT
// A scene in the data structures of a particle mesh, and its reference values from direct sums.
#pragma once

#include <vector>

#include "ewald.hpp"
#include "forces/mesh/particle_mesh.hpp"
#include "physics/force_laws.hpp"

namespace polhode {

inline Molecule ion(const char* name, double charge) {
  return rigid_molecule(
      name, {{.name = "I", .mass = 30, .charge = charge, .sigma = 0.3, .epsilon = 0.3}});
}

/// Water, linear molecules and two kinds of ions, in a box with three different edges; a net
/// charge.
inline scenes::Scene charged_mixture() {
  return scenes::spread({{{read_molecule("tip4p"), 30},
                          {ion("anion", -1), 3},
                          {read_molecule("co2"), 9},
                          {read_molecule("argon"), 2},
                          {ion("cation", 2), 2}}},
                        {1.6, 1.9, 1.75}, 17);
}

/// Forces and torques of bodies, in the order of bodies.
struct BodyLoads {
  std::vector<Vec3<double>> f, tau;
};

/// The records of a state, for a mesh.
template <class T>
struct MeshScene {
  NeighbourList list;
  SiteRecords<T> records;

  MeshScene(const Topology& topology, const State& state)
      : list(topology,
             {.cutoff = 0.4 * state.box.shortest_edge(),
              .switch_from = 0.3 * state.box.shortest_edge(),
              .skin = 0.05},
             state.box) {
    list.build(state, 16);
    std::size_t max_sites = 0;
    for (const auto& part : topology.parts)
      max_sites = std::max(max_sites, InteractionSites(part.molecule).size());
    records = SiteRecords<T>(list.slots().size(), max_sites);
    const auto place = POLHODE_CURRENT_OVERLOAD(place_sites, double (*)(const PlaceJob<T>&));
    for (std::size_t p = 0; p < topology.parts.size(); ++p) {
      std::vector<Vec3<double>> sites;
      for (const Site& site : InteractionSites(topology.parts[p].molecule).sites)
        sites.push_back(site.r);
      const Slots::Part& part = list.slots().parts[p];
      const std::size_t end = part.first + (part.count + slot_block - 1) / slot_block * slot_block;
      place({state, list.slots(), sites, part.first, end, records});
    }
  }

  MeshLoad operator()(ParticleMesh<T>& mesh, BodyLoads& loads) const {
    const Slots& slots = list.slots();
    Column<T> sums(slots.size() * ChunkSums<T>::stride);
    const MeshLoad load = mesh(slots, records, sums.data(), true);
    for (const Slots::Part& part : slots.parts) {
      loads.f.resize(loads.f.size() + part.count);
      loads.tau.resize(loads.tau.size() + part.count);
      for (std::size_t slot = part.first; slot < part.end(); ++slot) {
        const T* const s = &sums[slot * ChunkSums<T>::stride];
        loads.f[slots.body[slot]] = {s[0], s[1], s[2]};
        loads.tau[slots.body[slot]] = {s[3], s[4], s[5]};
      }
    }
    return load;
  }
};

/// The forces and torques of the mesh for a state, from newly created data.
template <class T>
MeshLoad mesh_load(const Topology& topology, const State& state, const MeshSettings& settings,
                   BodyLoads& loads, Workers& workers = Workers::serial()) {
  ParticleMesh<T> mesh(topology, settings, state.box, workers);
  return MeshScene<T>(topology, state)(mesh, loads);
}

/// The expected result of the mesh, from direct sums: the complete Ewald sum minus pairs and
/// constants.
struct ExactMesh {
  double energy;
  Mat3<double> virial;          ///< of charges that move with the box
  std::vector<Vec3<double>> f;  ///< on each charge, without those of the same body
  BodyLoads bodies;
  double rms;  ///< rms electrostatic force on a charge due to all others [kJ/mol/nm]

  ExactMesh(const Topology& topology, const State& state, const CompactSplit& split) {
    const PointCharges charges = point_charges(topology, state);
    // At half of the shortest edge erfc is 1e-14; the terms beyond the longest wave vector are as
    // small.
    const double alpha = 5.4 / (0.5 * state.box.shortest_edge());
    const EwaldSum all = ewald_sum(charges, state.box, GaussianSplit{alpha},
                                   {0.5 * state.box.shortest_edge(), 2 * alpha * 5.6});
    // Without wave vectors: pairs, and the other constants.
    const EwaldSum near = ewald_sum(charges, state.box, split, {split.cutoff(), 0});
    energy = all.energy.total() - near.energy.total();
    virial = all.virial;
    for (std::size_t d = 0; d < 3; ++d) virial[d] -= near.virial[d];
    bodies.f.resize(state.size()), bodies.tau.resize(state.size());
    rms = 0;
    for (std::size_t i = 0; i < charges.size(); ++i) {
      f.push_back(all.f[i] - near.f[i]);
      bodies.f[charges.body[i]] += f[i];
      bodies.tau[charges.body[i]] += cross(charges.r[i] - state.q[charges.body[i]], f[i]);
      rms += norm2(all.f[i]) / double(charges.size());
    }
    rms = std::sqrt(rms);
  }
};

}  // namespace polhode
