// SPDX-License-Identifier: MIT
#include "polhode/io/topology/topology_file.hpp"

#include "io/files/text_file.hpp"
#include "io/topology/lammps_data.hpp"

namespace polhode {

bool is_data_file(const std::string& path) {
  return path.ends_with(".data") || path.ends_with(".lmp");
}

RigidTopology read_topology(const TopologySettings& settings, const Frame* start) {
  if (is_data_file(settings.file)) return rigid_topology(read_lammps_data(settings.file));
  return rigid_topology(parse_gromacs(file_text(settings.file), settings.file,
                                      file_loader(settings.include), settings.define),
                        settings, start);
}

}  // namespace polhode
