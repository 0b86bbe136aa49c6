// SPDX-License-Identifier: MIT
// Tables of pair potentials: text files with three numbers on each line, r [nm], the energy u
// [kJ/mol] and the force −u' [kJ/mol/nm], at equal distances of r. '#' begins a comment.
#pragma once

#include <string>
#include <string_view>

#include "polhode/model/short_range.hpp"

namespace polhode {

/// Parses the text of a table; `file` is its name in errors and in the law.
/// @throws Error  with file and line: what was found, and what is required
TabulatedLaw parse_potential_table(std::string_view text, const std::string& file);

/// Reads the table that a molecule file or run file names, relative to that file; a built-in
/// molecule names a built-in table.
TabulatedLaw read_potential_table(const std::string& name, const std::string& named_in);

}  // namespace polhode
