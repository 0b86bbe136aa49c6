// SPDX-License-Identifier: MIT
// LAMMPS unit styles that are suitable for molecules.
#pragma once

#include <optional>
#include <string_view>

#include "io/settings/quantity.hpp"

namespace polhode {

struct LammpsUnits {
  double length;  ///< unit of length [nm]
  double time;    ///< unit of time [ps]
};

/// The units of a LAMMPS unit style.
/// @param style  argument of the command `units`
inline std::optional<LammpsUnits> lammps_units(std::string_view style) {
  const double angstrom = unit("A", Dimension::length), fs = unit("fs", Dimension::time);
  if (style == "real") return LammpsUnits{angstrom, fs};
  if (style == "metal") return LammpsUnits{angstrom, 1};
  if (style == "nano") return LammpsUnits{1, 1e3};
  return std::nullopt;
}

}  // namespace polhode
