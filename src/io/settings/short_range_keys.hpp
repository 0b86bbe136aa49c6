// SPDX-License-Identifier: MIT
// The keys of the short-range potential, in a table [[site]] of a molecule file or [[pair]] of a
// run file.
#pragma once

#include <string>

#include "polhode/model/short_range.hpp"
#include "toml_table.hpp"

namespace polhode {

struct ShortRangeKeys {
  double sigma = 0, epsilon = 0;  ///< diameter [nm] and well depth [kJ/mol]
  ShortRangeLaw law{};
};

/// The owner of a short-range potential: a site or a pair of sites. A site may have no potential,
/// whereas a pair must have a potential.
enum class LawOwner { site, pair };

/// Reads the keys of a short-range potential.
/// @param file  file that contains the table; names of potential tables are relative to this file
/// @throws Error  with file, line and key
ShortRangeKeys read_short_range(TomlTable& table, LawOwner owner, const std::string& file);

}  // namespace polhode
