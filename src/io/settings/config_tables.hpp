// SPDX-License-Identifier: MIT
// The tables of a run file, each read into its settings. Keys that are absent leave the defaults.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "polhode/base/enum_names.hpp"
#include "polhode/io/settings/config.hpp"
#include "toml_table.hpp"

namespace polhode {

/// @param file  the run file, to whose folder its paths are relative
void read_system(TomlTable table, const std::string& file, SystemSettings& system);
/// The tables [[shape]] of molecule types of a GROMACS topology.
void read_shapes(const std::vector<TomlTable>& tables, TopologySettings& topology);
void read_forces(TomlTable table, ForceSettings& forces);
/// The tables [[pair]]; the names of sites are checked against the molecules.
void read_pairs(const std::vector<TomlTable>& tables, const SystemSettings& system,
                const std::string& file, Mixing& mixing);
/// The texts of the schemes in the table [schemes], by name, such as "mine: B(1/2) A(1) B(1/2)".
OwnSchemes read_schemes(TomlTable table);

void read_integrator(TomlTable table, IntegratorSettings& integrator, const OwnSchemes& own);
void read_run(TomlTable table, RunSettings& run);
void read_preparation(TomlTable table, PreparationSettings& preparation);
void read_output(TomlTable table, OutputSettings& output);
ThermostatSettings read_thermostat(TomlTable table);
BarostatSettings read_barostat(TomlTable table);
HybridMonteCarloSettings read_hybrid_monte_carlo(TomlTable table);
void read_study(TomlTable table, StudySettings& study, const OwnSchemes& own);

template <class T>
void take(T& value, const std::optional<T>& found) {
  if (found) value = *found;
}

inline void take_time(TomlTable& table, std::string_view key, double& value,
                      std::string_view example) {
  take(value, table.quantity(key, Dimension::time, example));
}

/// A text that must be one of the names.
std::string one_of(TomlTable& table, std::string_view key, std::string_view fallback,
                   std::span<const std::string_view> names);

/// The value of a named enumeration.
template <NamedEnum Enum>
Enum one_of(TomlTable& table, std::string_view key, Enum fallback) {
  return *value_of<Enum>(one_of(table, key, name_of(fallback), enum_names<Enum>));
}

}  // namespace polhode
