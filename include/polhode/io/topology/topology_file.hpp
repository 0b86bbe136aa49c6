// SPDX-License-Identifier: MIT
// Files that define the molecules: GROMACS topologies and LAMMPS data files.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "polhode/forces/laws/mixing.hpp"
#include "polhode/io/coordinates/frame.hpp"
#include "polhode/io/topology/gromacs.hpp"
#include "polhode/math/shape.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// The keys of a run file about a topology file.
struct TopologySettings {
  std::string file;                  ///< path; empty: none
  std::vector<std::string> include;  ///< folders that are searched for `#include` files
  std::vector<std::string> define;   ///< GROMACS macros, "FLEXIBLE" or "NAME=VALUE"
  std::vector<std::string> rigid;    ///< molecule types to be made rigid although they are flexible
  /// Shapes of molecule types of a GROMACS topology, in place of those derived from it: positions
  /// of the atoms without virtual sites [nm].
  std::map<std::string, Shape> shapes{};
};

/// The molecules of a file as rigid bodies.
struct RigidTopology {
  Topology topology;
  Mixing mixing;
  bool rule_is_open = false;         ///< the file has no mixing rule, so the rule of the run file
                                     ///< applies
  bool rule_matters = false;         ///< whether some pairs use the mixing rule
  std::vector<std::string> origins;  ///< how the shape of each part was determined
  /// Shapes by molecule type, in the principal frame, which the topology does not determine: given,
  /// or taken from the initial configuration.
  std::map<std::string, Shape> shapes{};
};

/// Whether a file contains both topology and coordinates: a LAMMPS data file, by its extension.
bool is_data_file(const std::string& path);

/// Reads a topology file: a GROMACS topology, or a LAMMPS data file.
/// @param start  determines shapes that the file does not, and distinguishes mirror images; may be
///               null
/// @throws Error  with file and line
RigidTopology read_topology(const TopologySettings& settings, const Frame* start);

/// The molecules of a GROMACS topology as rigid bodies. Molecules in `shapes` have the given shape.
/// Molecules in `rigid` have the shape in which their bonds and angles are at their minimum, if
/// this determines a shape, otherwise the mean shape in the initial configuration. Settles and
/// constraints determine the shape of all other molecules.
/// @throws Error  if a molecule is not rigid, with the reason
RigidTopology rigid_topology(const GromacsTopology& gromacs, const TopologySettings& settings,
                             const Frame* start);

}  // namespace polhode
