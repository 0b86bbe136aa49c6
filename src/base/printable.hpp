// SPDX-License-Identifier: MIT
// Texts from outside (names of files, sites, molecules): escaped for the terminal, or refused as
// names.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace polhode {

/// The text with every control character (C0, DEL, C1) and every byte that is not UTF-8 as \xNN, so
/// that a terminal displays it and executes nothing in it.
std::string printable(std::string_view text);

/// Characters of a text in UTF-8.
std::size_t character_count(std::string_view text);

/// Refuses a name with such bytes, because names appear in scripts, tables and terminals.
/// @param what  has the name: "the output"
/// @throws Error  with the name and the first of these bytes
void check_name(std::string_view what, std::string_view name);

}  // namespace polhode
