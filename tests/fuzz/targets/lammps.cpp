// SPDX-License-Identifier: MIT
#include "../fuzz.hpp"
#include "io/topology/lammps_data.hpp"

void polhode::fuzz::read(std::string_view text) {
  const LammpsData data = parse_lammps_data(text, "fuzz.data");
  frame_of(data);
  rigid_topology(data);
}
