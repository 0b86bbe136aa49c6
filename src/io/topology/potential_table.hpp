// SPDX-License-Identifier: MIT
// Tables of pair potentials: text files with three numbers on each line. The numbers are r [nm],
// the energy u [kJ/mol] and the force −u' [kJ/mol/nm], at equally spaced r. '#' begins a comment.
#pragma once

#include <string>
#include <string_view>

#include "polhode/model/short_range.hpp"

namespace polhode {

/// Parses the text of a potential table. `file` is the file name in error messages and in the
/// potential.
/// @throws Error  with file, line, the text found and the text required
TabulatedLaw parse_potential_table(std::string_view text, const std::string& file);

/// Reads a potential table, whose path is relative to the molecule file or run file that refers to
/// the table. A built-in molecule refers to a built-in table.
TabulatedLaw read_potential_table(const std::string& name, const std::string& named_in);

}  // namespace polhode
