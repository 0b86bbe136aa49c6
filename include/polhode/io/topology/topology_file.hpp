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

/// The settings of a run file that select and interpret a topology file.
struct TopologySettings {
  std::string file;                  ///< path of the topology file; empty if there is none
  std::vector<std::string> include;  ///< folders that are searched for `#include` files
  std::vector<std::string> define;   ///< GROMACS macros, such as "FLEXIBLE" or "NAME=VALUE"
  std::vector<std::string> rigid;    ///< names of flexible molecule types to be made rigid
  /// Shapes of GROMACS molecule types, which replace the shapes derived from the topology. A shape
  /// consists of the positions of all atoms that are not virtual sites [nm].
  std::map<std::string, Shape> shapes{};
};

/// The molecules of a topology file as rigid bodies.
struct RigidTopology {
  Topology topology;
  Mixing mixing;
  bool rule_is_open = false;         ///< whether the mixing rule of the run file applies
  bool rule_matters = false;         ///< whether some pairs use the mixing rule
  std::vector<std::string> origins;  ///< how the shape of each molecule type was determined
  /// Shapes that the topology does not determine, by molecule type, in the principal frame. Such
  /// shapes are given by the user or taken from the initial configuration.
  std::map<std::string, Shape> shapes{};
};

/// Whether a file is a LAMMPS data file, which contains topology and coordinates. The file
/// extension decides.
bool is_data_file(const std::string& path);

/// Reads a topology file: a GROMACS topology, or a LAMMPS data file.
/// @param start  initial configuration, which determines shapes that the file leaves open and
///   distinguishes mirror images; may be null
/// @throws Error  with file and line
RigidTopology read_topology(const TopologySettings& settings, const Frame* start);

/// Converts the molecules of a GROMACS topology to rigid bodies. Molecules in `shapes` have the
/// given shape. The equilibrium values of bonds and angles give the shape of each molecule in
/// `rigid`. If bonds and angles do not determine a shape, the mean shape in the initial
/// configuration is used. Settles and constraints determine the shape of all other molecules.
/// @throws Error  if a molecule is not rigid, with the reason
RigidTopology rigid_topology(const GromacsTopology& gromacs, const TopologySettings& settings,
                             const Frame* start);

}  // namespace polhode
