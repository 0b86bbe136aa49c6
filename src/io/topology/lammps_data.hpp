// SPDX-License-Identifier: MIT
// LAMMPS data files of atom_style full in units real: Å, fs, kcal/mol, e, g/mol. Molecule ids are
// rigid bodies.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "polhode/io/coordinates/frame.hpp"
#include "polhode/io/topology/topology_file.hpp"

namespace polhode {

/// A data file's atoms, put in order: molecules of one kind together, kinds in the order of their
/// first molecule id, atoms by their ids.
struct LammpsData {
  struct AtomType {
    double mass = 0;                ///< [u]
    std::string site;               ///< the name that an export writes behind the mass, or empty
    double sigma = 0, epsilon = 0;  ///< [nm], [kJ/mol]
    ShortRangeLaw law{};
    bool has_pair_coefficients = false;
  };
  struct Atom {
    std::int64_t id, molecule;
    int type;
    double charge;
    Vec3<double> r, v;  ///< [nm], unwrapped by the image flags; [nm/ps]
  };
  /// Bodies with the same types and charges in the same shape.
  struct Kind {
    std::string name;  ///< "OH2", of elements in the order of atoms
    std::vector<std::string> sites;
    std::size_t first = 0;  ///< index of its first atom
    std::size_t count = 0;
  };
  std::string title, file;
  std::map<int, AtomType> types;
  std::vector<TypePair> pairs;  ///< of `PairIJ Coeffs`
  std::string pair_style;       ///< behind `Pair Coeffs #`; empty: not given
  std::vector<Atom> atoms;
  std::vector<Kind> kinds;
  bool has_velocities = false;
  Box box;  ///< [nm]; its lower corner is moved to the origin
};

/// @throws Error  with file and line: what was found, and what was expected
LammpsData parse_lammps_data(std::string_view text, const std::string& file);
LammpsData read_lammps_data(const std::string& path);

/// The atoms as a frame: in their order, as a topology of this file has them, or by their ids, as
/// trajectories of LAMMPS have them.
enum class AtomOrder { of_kinds, of_ids };
Frame frame_of(const LammpsData& data, AtomOrder order = AtomOrder::of_kinds);

/// Every kind as a rigid molecule: the mean shape of its copies.
/// @throws Error  if the file does not define the forces
RigidTopology rigid_topology(const LammpsData& data);

}  // namespace polhode
