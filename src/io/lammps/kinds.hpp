// SPDX-License-Identifier: MIT
// Which molecules of a LAMMPS data file are of one kind.
#pragma once

#include "io/topology/lammps_data.hpp"

namespace polhode {

/// Sorts the atoms by kind, and names kinds and sites.
/// @throws Error  if there are more kinds than a topology can have
void sort_into_kinds(LammpsData& data);

/// The element of an atom type by its mass. Empty if there is none, or if the name of its site
/// contradicts it: united atoms have masses of no element, or of another one, as CH2 that of N.
std::string element_of(const LammpsData::AtomType& type);

/// The positions of one copy's atoms, relative to its first [nm].
Shape shape_of(const LammpsData& data, const LammpsData::Kind& kind, std::size_t copy);

}  // namespace polhode
