// SPDX-License-Identifier: MIT
// Quantities as users write them ("2 fs"), converted to internal units. The only file that contains
// conversion factors.
#pragma once

#include <string>
#include <string_view>

#include "polhode/base/vec3.hpp"

namespace polhode {

enum class Dimension {
  length,           ///< [nm]
  time,             ///< [ps], simulated time
  wall_clock,       ///< [s], wall-clock time
  mass,             ///< [u]
  charge,           ///< [e]
  temperature,      ///< [K]
  force,            ///< [kJ/mol/nm]
  energy,           ///< [kJ/mol]; "K" means energy divided by Boltzmann's constant
  density,          ///< [u/nm³]
  dipole,           ///< [e nm]
  pressure,         ///< [kJ/mol/nm³]
  power,            ///< [kJ/mol/ps]; "K" means energy divided by Boltzmann's constant
  viscosity,        ///< [u/(nm ps)]
  fraction,         ///< [1], written in %
  inverse_length,   ///< [1/nm]
  rate,             ///< [1/ps]
  compressibility,  ///< [nm³ mol/kJ]
  dispersion,       ///< coefficient of 1/r⁶ [kJ/mol nm⁶]
};

/// A number with its unit, "0.1550 kcal/mol", in internal units. `name` is the quantity that the
/// text stands for; `example` replaces the dimension's own example in errors where that would
/// mislead.
/// @throws Error  if the unit is missing, unknown or of another dimension, or the number not finite
double quantity(std::string_view text, Dimension dimension, std::string_view name,
                std::string_view example = {});

/// Three numbers with a common unit: "0 0.015 0 nm".
Vec3<double> vector_quantity(std::string_view text, Dimension dimension, std::string_view name);

/// The message about a bare number, with a suggestion: `step = 2 has no unit; write for example "2
/// fs"`.
std::string no_unit(std::string_view name, std::string_view number, Dimension dimension,
                    std::string_view example = {});

/// The name of a dimension, "inverse length".
std::string_view noun(Dimension dimension);
/// A unit that quantities of a dimension are written in: "kJ/mol/ns".
std::string_view unit_of(Dimension dimension);

/// The value of a unit in internal units: unit("fs", Dimension::time) = 0.001.
/// @throws Error  if there is no such unit
double unit(std::string_view symbol, Dimension dimension);

}  // namespace polhode
