// SPDX-License-Identifier: MIT
// Determines the kinds of molecules in a LAMMPS data file.
#pragma once

#include "io/topology/lammps_data.hpp"

namespace polhode {

/// Sorts the atoms by kind of molecule, and names kinds and sites.
/// @throws Error  if there are more kinds than a topology can have
void sort_into_kinds(LammpsData& data);

/// The element of an atom type, found by its mass. The result is empty if no element has this mass,
/// or if the name of the site contradicts the element. The mass of a united atom may match no
/// element, or match another element, such as N for CH2.
std::string element_of(const LammpsData::AtomType& type);

/// The positions of the atoms of one molecule, relative to the first atom of the molecule [nm].
Shape shape_of(const LammpsData& data, const LammpsData::Kind& kind, std::size_t copy);

}  // namespace polhode
