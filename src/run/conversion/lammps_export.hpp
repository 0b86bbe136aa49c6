// SPDX-License-Identifier: MIT
// A run file as input of LAMMPS with the plugin of this project.
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

/// Which pair style computes the forces.
enum class LammpsPairStyle {
  table,      ///< pair_style table, with coul/long for the charges of the Ewald sum
  kernel,     ///< pair_style polhode, of the plugin
  particles,  ///< the same, with one particle a molecule
};
template <>
inline constexpr std::array<std::string_view, 3> enum_names<LammpsPairStyle> = {
    "table", "polhode", "polhode-particles"};

/// Writes PREFIX.data, the system at its initial configuration, PREFIX.in, an input script that
/// performs the run by fix polhode, and what the style needs: PREFIX.table, the pair laws as
/// tables, or PREFIX-1.molecule and so on, the sites of particles.
/// @return  the files
/// @throws Error  if the run has what LAMMPS or the pair style cannot do, or as check_outputs()
std::vector<std::string> export_to_lammps(const Config& config, LammpsPairStyle style,
                                          const OutputOptions& options,
                                          const Callbacks& callbacks = {});

}  // namespace polhode
