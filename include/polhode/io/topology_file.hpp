// SPDX-License-Identifier: MIT
// Files that say which molecules there are: GROMACS topologies and LAMMPS data files.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "polhode/forces/mixing.hpp"
#include "polhode/io/frame.hpp"
#include "polhode/io/gromacs.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// What a run file says of a topology file.
struct TopologySettings {
  std::string file;                  ///< path; empty: there is none
  std::vector<std::string> include;  ///< folders in which `#include` looks
  std::vector<std::string> define;   ///< macros of GROMACS, "FLEXIBLE" or "NAME=VALUE"
  std::vector<std::string> rigid;    ///< molecule types that are to be rigid although they are not
};

/// Molecules of a file as rigid bodies.
struct RigidTopology {
  Topology topology;
  Mixing mixing;
  bool rule_is_open = false;         ///< the file has no mixing rule: the run file's holds
  bool rule_matters = false;         ///< and some pairs are mixed by it
  std::vector<std::string> origins;  ///< of each part: how its shape was found
};

/// Whether a file holds molecules and coordinates in one: a LAMMPS data file, by its ending.
bool is_data_file(const std::string& path);

/// Reads a topology file: a GROMACS topology, or a LAMMPS data file.
/// @param start  gives the shapes of molecules that nothing else does, and tells mirror images
///               apart; may be null
/// @throws Error  with file and line
RigidTopology read_topology(const TopologySettings& settings, const Frame* start);

/// The molecules of a GROMACS topology as rigid bodies: those of `rigid` have the shape of bonds
/// and angles at their minimum if these fix it, else the mean shape of those in the start; all
/// others that of settles and constraints.
/// @throws Error  if a molecule is not rigid, with the reason
RigidTopology rigid_topology(const GromacsTopology& gromacs, const std::vector<std::string>& rigid,
                             const Frame* start);

}  // namespace polhode
