// SPDX-License-Identifier: MIT
// LAMMPS data files of atom_style full in units real: Å, fs, kcal/mol, e, g/mol. All atoms with the
// same molecule id form a rigid body.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "polhode/io/coordinates/frame.hpp"
#include "polhode/io/topology/topology_file.hpp"

namespace polhode {

/// The contents of a LAMMPS data file, with the atoms sorted. Molecules of the same kind are
/// contiguous. Kinds are in the order of the first molecule id, and the atoms of a molecule are in
/// the order of their ids.
struct LammpsData {
  struct AtomType {
    double mass = 0;                ///< mass [u]
    std::string site;               ///< site name, from the comment of exports; may be empty
    double sigma = 0, epsilon = 0;  ///< diameter [nm] and well depth [kJ/mol]
    ShortRangeLaw law{};
    bool has_pair_coefficients = false;
  };
  struct Atom {
    std::int64_t id, molecule;
    int type;
    double charge;
    Vec3<double> r, v;  ///< position [nm], unwrapped with the image flags, and velocity [nm/ps]
  };
  /// A kind of molecule: bodies with the same types and charges in the same shape.
  struct Kind {
    std::string name;  ///< name made from the elements in the order of the atoms, such as "OH2"
    std::vector<std::string> sites;
    std::size_t first = 0;  ///< index of the first atom of the kind
    std::size_t count = 0;
  };
  std::string title, file;
  std::map<int, AtomType> types;
  std::vector<TypePair> pairs;  ///< pairs of `PairIJ Coeffs`
  std::string pair_style;       ///< pair style after `Pair Coeffs #`; empty if absent
  std::vector<Atom> atoms;
  std::vector<Kind> kinds;
  bool has_velocities = false;
  Box box;  ///< box [nm]; its lower corner is moved to the origin
};

enum class LammpsLaw { lennard_jones, buckingham, mie };

/// The short-range potential of a LAMMPS pair style, with any accelerator suffix and any treatment
/// of charges. The potential is Lennard-Jones if no style is given, and empty for unsupported
/// styles.
std::optional<LammpsLaw> law_of_pair_style(std::string_view style);

/// Parses the text of a LAMMPS data file.
/// @throws Error  with file, line, the text found and the text expected
LammpsData parse_lammps_data(std::string_view text, const std::string& file);
LammpsData read_lammps_data(const std::string& path);

/// The order of atoms in a frame: either by kinds of molecules, as in the topology of this file, or
/// by ids, as in LAMMPS trajectories.
enum class AtomOrder { of_kinds, of_ids };
Frame frame_of(const LammpsData& data, AtomOrder order = AtomOrder::of_kinds);

/// Converts every kind to a rigid molecule with the mean shape of its copies.
/// @throws Error  if the file does not define the forces
RigidTopology rigid_topology(const LammpsData& data);

}  // namespace polhode
