// SPDX-License-Identifier: MIT
// A frame: the atoms at one time as in coordinate files, without rigid bodies. Readers produce
// frames and writers take them; the functions below convert between bodies and atoms.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// Properties of all atoms of the same name, stored once for frames with many atoms.
struct AtomKind {
  std::string residue_name;  ///< "SOL"
  std::string name;          ///< "OW"
  std::string element;       ///< "O"; empty if unknown, or for massless sites
};

struct Atom {
  std::uint32_t kind = 0;  ///< index into Frame::kinds
  int residue = 0;         ///< number of its molecule
  Vec3<double> r;          ///< [nm]
  Vec3<double> v;          ///< [nm/ps]
};

struct Frame {
  std::string title;
  std::vector<AtomKind> kinds;
  std::vector<Atom> atoms;
  bool has_velocities = false;
  Box box;             ///< [nm]
  double time = 0;     ///< [ps]
  std::string source;  ///< file that it was read from

  const AtomKind& kind(const Atom& atom) const { return kinds[atom.kind]; }
};

/// Assigns elements to kinds without one, from the names that GROMACS and PDB files use: "OW" is O,
/// and "NA" in a residue of that name is Na. Names that do not begin with an element ("MW") get
/// none.
void complete_elements(Frame& frame);

enum class MasslessSites { keep, omit };

/// All sites of all bodies: r = q + x, v = p/m + ω × x. Molecules are whole, with their centres
/// wrapped into the box.
Frame frame_of(const State& state, const Topology& topology,
               MasslessSites massless = MasslessSites::keep);

/// The kinds of atoms in such a frame: the sites of the topology.
std::vector<AtomKind> atom_kinds(const Topology& topology, MasslessSites massless);

/// Calls visit(atom) for each atom of such a frame, so that the frame need not be in memory.
void each_atom(const State& state, const Topology& topology, MasslessSites massless,
               const std::function<void(const Atom&)>& visit);
std::size_t atom_count(const Topology& topology, MasslessSites massless = MasslessSites::keep);
std::string title_of(const State& state);  ///< title of such a frame, with the time [ps]

/// Rigid bodies fitted to a frame.
struct FittedState {
  State state;                  ///< state at time 0
  bool has_velocities = false;  ///< otherwise all momenta are zero
  double deviation = 0;         ///< largest distance of an atom with mass from its site [nm]
  /// Largest deviation of massless sites [nm]. It may have any value, because their positions in
  /// the file are ignored and follow from the other sites.
  double massless_deviation = 0;
};

/// Fits rigid bodies to atoms. Atoms are assigned to the topology's bodies in order; sites without
/// mass may be missing. Molecules broken across the boundary are made whole; orientations minimize
/// Σ m |Δr|² [horn1987]. Momenta are sums over atoms: p = Σ m v, ℓ = Σ m (r − q) × v.
/// @throws Error  if atoms do not match sites, are too few or too many, or if atoms with mass are
///                farther than `fit_tolerance` from the model
FittedState fit_state(const Frame& frame, const Topology& topology);

/// Largest allowed distance of atoms from the sites of a rigid model [nm]. The geometries of water
/// models differ by up to 0.01 nm, and other isomers by more than 0.02 nm.
inline constexpr double fit_tolerance = 0.02;

/// The topology with its only count, if it is 0, set to the number of molecules in the frame.
Topology complete_topology(Topology topology, const Frame& frame);

}  // namespace polhode
