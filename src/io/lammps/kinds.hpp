// SPDX-License-Identifier: MIT
// Determines the kinds of molecules in a LAMMPS data file.
#pragma once

#include "io/topology/lammps_data.hpp"

namespace polhode {

/// Sorts the atoms by kind of molecule, and names kinds and sites.
/// @throws Error  if there are more kinds than a topology can have
void sort_into_kinds(LammpsData& data);

/// The element of an atom type, found by its mass. Empty if there is none, or if the name of the
/// site contradicts it. The mass of a united atom may match no element, or another element, such as
/// N for CH2.
std::string element_of(const LammpsData::AtomType& type);

/// The positions of the atoms of one copy, relative to its first atom [nm].
Shape shape_of(const LammpsData& data, const LammpsData::Kind& kind, std::size_t copy);

}  // namespace polhode
