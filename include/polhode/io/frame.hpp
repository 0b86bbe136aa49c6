// SPDX-License-Identifier: MIT
// A frame: the atoms of one instant as coordinate files know them, without rigid bodies. Readers
// make it, writers take it, and these functions lead from bodies to atoms and back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// What atoms of one name have in common: kept once, for frames of many atoms.
struct AtomKind {
  std::string residue_name;  ///< "SOL"
  std::string name;          ///< "OW"
  std::string element;       ///< "O"; empty if the file does not tell, or for massless sites
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

/// Gives elements to kinds without one, by the names that GROMACS and PDB files use: "OW" is O, and
/// "NA" in a residue of that name is Na. Names that begin with no such element ("MW") are left.
void complete_elements(Frame& frame);

enum class MasslessSites { kept, left_out };

/// All sites of all bodies: r = q + x, v = p/m + ω × x. Molecules stay whole, with their centres
/// moved into the box.
Frame frame_of(const State& state, const Topology& topology,
               MasslessSites massless = MasslessSites::kept);

/// The kinds of that frame's atoms: the topology's sites.
std::vector<AtomKind> atom_kinds(const Topology& topology, MasslessSites massless);

/// Calls visit(atom) for the atoms of that frame one after another: a frame need not be held whole.
void each_atom(const State& state, const Topology& topology, MasslessSites massless,
               const std::function<void(const Atom&)>& visit);
std::size_t atom_count(const Topology& topology, MasslessSites massless = MasslessSites::kept);
std::string title_of(const State& state);  ///< of that frame: it tells the time [ps]

/// What a frame gives for rigid bodies.
struct FittedState {
  State state;                  ///< at time 0
  bool has_velocities = false;  ///< else all momenta are zero
  double deviation = 0;         ///< largest distance of an atom with mass from its site [nm]
  /// The same of massless sites [nm], which may lie anywhere: their places follow from the others,
  /// whatever the file says.
  double massless_deviation = 0;
};

/// Rigid bodies fitted to atoms. Atoms belong to the topology's bodies in order; sites without mass
/// may be missing. Molecules broken across the boundary are made whole; attitudes minimise Σ m
/// |Δr|² (horn1987), and momenta are those of the atoms: p = Σ m v, ℓ = Σ m (r − q) × v.
/// @throws Error  if atoms do not match sites, are too few or too many, or if those with mass lie
///                further than `fit_tolerance` from the model
FittedState fitted_state(const Frame& frame, const Topology& topology);

/// Atoms may lie this far from the sites of a rigid model [nm]: the geometries of water models
/// differ by up to 0.01 nm, another isomer by more than twice that.
inline constexpr double fit_tolerance = 0.02;

/// The topology with its only count, if it is 0, set to the number of molecules in the frame.
Topology completed(Topology topology, const Frame& frame);

}  // namespace polhode
