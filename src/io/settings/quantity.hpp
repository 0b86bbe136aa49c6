// SPDX-License-Identifier: MIT
// Quantities as users write them ("2 fs"), converted to internal units. Only the source file that
// implements this header contains conversion factors.
#pragma once

#include <string>
#include <string_view>

#include "polhode/base/vec3.hpp"

namespace polhode {

enum class Dimension {
  length,           ///< [nm]
  time,             ///< simulated time [ps]
  wall_clock,       ///< wall-clock time [s]
  mass,             ///< [u]
  charge,           ///< [e]
  temperature,      ///< [K]
  force,            ///< [kJ/mol/nm]
  energy,           ///< energy [kJ/mol]; the unit "K" means energy divided by Boltzmann's constant
  density,          ///< [u/nm³]
  dipole,           ///< [e nm]
  pressure,         ///< [kJ/mol/nm³]
  power,            ///< power [kJ/mol/ps]; the unit "K" as for energies
  viscosity,        ///< [u/(nm ps)]
  fraction,         ///< fraction [1], written in %
  inverse_length,   ///< [1/nm]
  rate,             ///< [1/ps]
  compressibility,  ///< [nm³ mol/kJ]
  dispersion,       ///< coefficient of 1/r⁶ [kJ/mol nm⁶]
};

/// Parses a number with a unit, such as "0.1550 kcal/mol", and converts the number to internal
/// units. `name` is the name of the quantity in error messages. `example` replaces the usual
/// example of the dimension in error messages if the usual example would be misleading.
/// @throws Error  if the unit is missing, unknown or of another dimension, or the number is not
///   finite
double quantity(std::string_view text, Dimension dimension, std::string_view name,
                std::string_view example = {});

/// Parses three numbers with a common unit, such as "0 0.015 0 nm".
Vec3<double> vector_quantity(std::string_view text, Dimension dimension, std::string_view name);

/// The message about a number without a unit, with a suggestion:
/// `step = 2 has no unit; write for example "2 fs"`.
std::string no_unit(std::string_view name, std::string_view number, Dimension dimension,
                    std::string_view example = {});

/// The name of a dimension, such as "inverse length".
std::string_view noun(Dimension dimension);
/// The usual unit of a dimension, such as "kJ/mol/ns".
std::string_view unit_of(Dimension dimension);

/// The value of a unit in internal units, for example 0.001 for unit("fs", Dimension::time).
/// @throws Error  if the unit does not exist
double unit(std::string_view symbol, Dimension dimension);

}  // namespace polhode
