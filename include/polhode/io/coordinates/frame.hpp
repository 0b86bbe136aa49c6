// SPDX-License-Identifier: MIT
// A frame: the atoms at one time as in coordinate files, without rigid bodies. Readers produce
// frames and writers consume frames; the functions below convert between bodies and atoms.
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
  std::string residue_name;  ///< name of the residue: "SOL"
  std::string name;          ///< name of the atom: "OW"
  std::string element;       ///< chemical symbol, "O"; empty if unknown, or for massless sites
};

struct Atom {
  std::uint32_t kind = 0;  ///< index into Frame::kinds
  int residue = 0;         ///< number of the atom's molecule
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
  std::string source;  ///< name of the file that the frame was read from

  const AtomKind& kind(const Atom& atom) const { return kinds[atom.kind]; }
};

/// Assigns missing elements to kinds, from the names that GROMACS and PDB files use. "OW" is
/// oxygen, and "NA" in a residue of the same name is sodium. A kind whose name does not begin with
/// an element ("MW") gets no element.
void complete_elements(Frame& frame);

enum class MasslessSites { keep, omit };

/// The frame with all sites of all bodies. A site with the offset x from the centre q of its body
/// has r = q + x and v = p/m + ω × x. Molecules are whole, and molecule centres are wrapped into
/// the box.
Frame frame_of(const State& state, const Topology& topology,
               MasslessSites massless = MasslessSites::keep);

/// The kinds of atoms in frame_of(): the sites of the topology.
std::vector<AtomKind> atom_kinds(const Topology& topology, MasslessSites massless);

/// Calls visit(atom) for each atom of frame_of(), without storing the frame.
void each_atom(const State& state, const Topology& topology, MasslessSites massless,
               const std::function<void(const Atom&)>& visit);
std::size_t atom_count(const Topology& topology, MasslessSites massless = MasslessSites::keep);
std::string title_of(const State& state);  ///< title of the frame of a state, with the time [ps]

/// Rigid bodies fitted to a frame.
struct FittedState {
  State state;                  ///< state at time 0
  bool has_velocities = false;  ///< if false, all momenta are zero
  double deviation = 0;         ///< largest distance of an atom with mass from its model site [nm]
  /// Largest distance of a massless site from its model position [nm]. This distance has no limit,
  /// because readers ignore the positions of massless sites.
  double massless_deviation = 0;
};

/// Fits rigid bodies to atoms. Atoms are assigned to the topology's bodies in order; massless sites
/// may be missing. Molecules split across the periodic boundary are made whole. Orientations
/// minimize Σ m |Δr|² [horn1987]. Momenta are sums over atoms: p = Σ m v, ℓ = Σ m (r − q) × v.
/// @throws Error  if atoms do not match sites, are too few or too many, or if an atom with mass is
///   farther than `fit_tolerance` from the model
FittedState fit_state(const Frame& frame, const Topology& topology);

/// Largest allowed distance of atoms from the sites of a rigid model [nm]. The geometries of water
/// models differ by up to 0.01 nm, and isomers differ by more than 0.02 nm.
inline constexpr double fit_tolerance = 0.02;

/// If the only molecule count of a topology is 0, this count becomes the number of molecules in the
/// frame.
Topology complete_topology(Topology topology, const Frame& frame);

}  // namespace polhode
