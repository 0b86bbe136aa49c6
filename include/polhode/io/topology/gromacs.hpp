// SPDX-License-Identifier: MIT
// Reads GROMACS topologies (.top and .itp files with preprocessor directives) as far as rigid
// bodies require.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "polhode/forces/laws/mixing.hpp"
#include "polhode/io/settings/text_place.hpp"
#include "polhode/io/settings/type_pairs.hpp"
#include "polhode/math/distances.hpp"
#include "polhode/math/shape.hpp"
#include "polhode/model/molecule.hpp"

namespace polhode {

/// The text of a file, and the name of the file in error messages.
struct LoadedText {
  std::string file, text;
};

/// A function that finds the file of an `#include` line.
/// @param name      file name as written after `#include`
/// @param includer  name of the including file, as the loader returned it
using IncludeLoader =
    std::function<std::optional<LoadedText>(const std::string& name, const std::string& includer)>;

/// One line of `[ atomtypes ]`.
struct GromacsAtomType {
  std::string name;
  std::string bonded;     ///< name of the type in [ bondtypes ] and similar sections
  int atomic_number = 0;  ///< 0: not given
  double mass = 0;        ///< [u]
  double charge = 0;      ///< [e]
  double sigma = 0;       ///< [nm]
  double epsilon = 0;     ///< [kJ/mol]
  ShortRangeLaw law{};
  bool one_sided = false;  ///< whether one of C6 and C12 is 0: no sigma and epsilon give this
  TextPlace place;

  bool same_parameters(const GromacsAtomType& other) const {
    return bonded == other.bonded && atomic_number == other.atomic_number && mass == other.mass &&
           charge == other.charge && sigma == other.sigma && epsilon == other.epsilon &&
           law == other.law && one_sided == other.one_sided;
  }
};

struct GromacsAtom {
  std::string type, name;
  double charge = 0, mass = 0;
  TextPlace place;
};

/// A line of a molecule type that relates several atoms, such as a bond, angle, constraint or
/// virtual site.
struct GromacsRelation {
  enum class Kind : std::uint8_t { settle, constraint, bond, angle, virtual2, virtual3 };
  Kind kind;
  std::uint8_t function = 1;
  std::uint8_t given = 0;  ///< how many elements of `numbers` the line gives
  std::array<std::uint32_t, 4>
      atoms{};  ///< indices of the atoms; for a virtual site, the index of the site itself is first
  std::array<double, 3> numbers{};  ///< lengths [nm], angles [degrees], weights
  TextPlace place;
};

struct GromacsMolecule {
  std::string name;
  TextPlace place;
  std::vector<GromacsAtom> atoms;
  std::vector<GromacsRelation> relations;
  std::string obstacle;  ///< first section that is not allowed in a rigid body, with its place
  TextPlace obstacle_place;
};

/// Equilibrium lengths [nm] and angles [degrees] from `[ bondtypes ]` and similar sections, by the
/// bonded types of the atoms: "C O".
struct GromacsEquilibrium {
  std::map<std::string, double> bonds, constraints, angles;
};

struct GromacsTopology {
  std::string title;
  MixingRule rule = MixingRule::geometric;
  std::map<std::string, GromacsAtomType> types;
  std::vector<TypePair> pairs;  ///< pair parameters of `[ nonbond_params ]`
  GromacsEquilibrium equilibrium;
  std::vector<GromacsMolecule> molecules;
  struct Block {
    std::size_t molecule;  ///< index into `molecules`
    std::size_t count;
  };
  std::vector<Block> blocks;  ///< blocks of `[ molecules ]`, in the order of the file
  std::string file;
};

/// Parses the text of a topology, with all files that it includes.
/// @param file     file name in error messages
/// @param defines  macros defined before the first line, such as "FLEXIBLE" or "NAME=VALUE"
/// @throws Error   with file, line, the text found and the text expected
GromacsTopology parse_gromacs(std::string_view text, const std::string& file,
                              const IncludeLoader& loader,
                              const std::vector<std::string>& defines = {});

/// Finds included files as GROMACS does. The search covers the folder of the including file,
/// `folders`, the folders in GMXLIB and GMXDATA, and the installed GROMACS data folder.
IncludeLoader file_loader(std::vector<std::string> folders);

/// Selects the distances between real atoms that determine a rigid shape. Settles and constraints
/// fix these distances. With `by_bonds`, the equilibrium values of bonds and angles fix further
/// distances.
enum class Rigidity { by_constraints, by_bonds };
std::vector<Distance> constrained_distances(const GromacsTopology& topology,
                                            const GromacsMolecule& molecule, Rigidity rigidity);

/// The rigid molecule with a given shape of the real atoms, and with its virtual sites.
/// @param shape  positions of the real atoms in their order [nm]
Molecule rigid_molecule(const GromacsTopology& topology, const GromacsMolecule& molecule,
                        const Shape& shape);

/// Indices of the atoms of a molecule that are not virtual sites.
std::vector<std::size_t> real_atoms(const GromacsMolecule& molecule);

/// The folder of the GROMACS force fields on this computer, if GROMACS is installed.
std::optional<std::string> gromacs_data_folder();

}  // namespace polhode
