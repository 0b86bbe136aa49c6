// SPDX-License-Identifier: MIT
#pragma once

#include "io/topology/lammps_export.hpp"

namespace polhode {

/// A molecule with a single site of a given type. The pair table of two molecules with one site
/// each has one pair, which follows from the mixing rule or an exception.
inline Molecule lone_site(const LammpsTypes::Type& type, const Topology& topology, double charge) {
  Molecule molecule;
  molecule.name = topology.parts[type.part].molecule.name;
  molecule.sites = {type.site};
  molecule.sites[0].r = {};
  molecule.sites[0].charge = charge;
  return molecule;
}

}  // namespace polhode
