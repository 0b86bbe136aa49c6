// SPDX-License-Identifier: MIT
// Exports a run file as LAMMPS input for the plugin of this project.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "polhode/base/enum_names.hpp"
#include "polhode/io/settings/config.hpp"
#include "polhode/run/callbacks.hpp"
#include "polhode/run/outputs.hpp"

namespace polhode {

/// The pair style that computes the forces in LAMMPS.
enum class LammpsPairStyle {
  table,      ///< pair_style table, and coul/long for the charges of the Ewald sum
  kernel,     ///< pair_style polhode of the plugin, with an atom for each site
  particles,  ///< pair_style polhode of the plugin, with one particle for each molecule
};
template <>
inline constexpr std::array<std::string_view, 3> enum_names<LammpsPairStyle> = {
    "table", "polhode", "polhode-particles"};

/// Exports a run to LAMMPS. PREFIX.data contains the system at its initial configuration. PREFIX.in
/// is an input script that performs the run with fix polhode. Depending on the style, PREFIX.table
/// contains the pair potentials as tables, or PREFIX-1.molecule and similar files contain the sites
/// of particles.
/// @return  paths of the files
/// @throws Error  if the run has features that LAMMPS or the pair style does not support, or under
///   the conditions of check_outputs()
std::vector<std::string> export_to_lammps(const Config& config, LammpsPairStyle style,
                                          const OutputOptions& options,
                                          const Callbacks& callbacks = {});

}  // namespace polhode
