// SPDX-License-Identifier: MIT
#pragma once

#include "io/topology/lammps_export.hpp"

namespace polhode {

/// A molecule of one site, that of a type, with the name of its own: the table of two of these has
/// one pair, by the mixing rule and its exceptions.
inline Molecule lone_site(const LammpsTypes::Type& type, const Topology& topology, double charge) {
  Molecule molecule;
  molecule.name = topology.parts[type.part].molecule.name;
  molecule.sites = {type.site};
  molecule.sites[0].r = {};
  molecule.sites[0].charge = charge;
  return molecule;
}

}  // namespace polhode
