// SPDX-License-Identifier: MIT
// Texts from outside (names of files, sites, molecules): escaped for the terminal, or refused as
// names.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace polhode {

/// A text in which every control character (C0, DEL, C1) and every byte that is not UTF-8 is
/// written as \xNN. A terminal then displays the text without executing anything in it.
std::string printable(std::string_view text);

/// The number of characters in a UTF-8 text.
std::size_t character_count(std::string_view text);

/// Rejects a name with control characters or bytes that are not UTF-8, because names appear in
/// scripts, tables and terminals.
/// @param what  object that has the name, such as "the output"
/// @throws Error  with the name and the first such byte
void check_name(std::string_view what, std::string_view name);

}  // namespace polhode
