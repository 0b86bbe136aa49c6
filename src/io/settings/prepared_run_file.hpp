// SPDX-License-Identifier: MIT
// The run file of a prepared system: a copy of the run file of its preparation, with the prepared
// coordinates.
#pragma once

#include <string>

#include "polhode/io/settings/config.hpp"

namespace polhode {

/// Makes the run file that starts from a prepared configuration. The new initial configuration
/// replaces the density, box or initial configuration of the Config. Minimisation, equilibration
/// and preparation are removed. Temperature, seed and pressure are taken from the Config. Paths are
/// relative to the folder of the new run file. A compressibility that differs from the default is
/// added if the run file has none.
/// @param coordinates, checkpoint, run_file  paths of the new initial configuration, the checkpoint
///   with its full precision, and the new run file
std::string prepared_run_file(const Config& config, const std::string& coordinates,
                              const std::string& checkpoint, const std::string& run_file);

}  // namespace polhode
