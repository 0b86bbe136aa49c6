// SPDX-License-Identifier: MIT
// Texts from outside (names of files, sites, molecules), made safe for a terminal, or refused where
// they name something.
#pragma once

#include <string>
#include <string_view>

namespace polhode {

/// The text with every control character (C0, DEL, C1) and every byte that is not UTF-8 as \xNN, so
/// that a terminal shows it and obeys nothing in it.
std::string printable(std::string_view text);

/// Refuses a name that is not printable as it is: names end up in scripts, tables and terminals.
/// @param what  it names: "the output"
/// @throws Error  with the name and its first such byte
void check_name(std::string_view what, std::string_view name);

}  // namespace polhode
