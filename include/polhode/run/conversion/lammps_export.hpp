// SPDX-License-Identifier: MIT
// A run file as input of LAMMPS with the plugin of this project.
#pragma once

#include <string>
#include <vector>

#include "polhode/io/config.hpp"
#include "polhode/run/callbacks.hpp"
#include "polhode/run/outputs.hpp"

namespace polhode {

/// Writes PREFIX.data, PREFIX.table and PREFIX.in: the system at its initial configuration, the
/// pair laws, and an input script that performs the run by fix polhode.
/// @return  the files
/// @throws Error  if the run has what LAMMPS cannot do, or as check_outputs()
std::vector<std::string> export_to_lammps(const Config& config, const OutputOptions& options,
                                          const Callbacks& callbacks = {});

}  // namespace polhode
