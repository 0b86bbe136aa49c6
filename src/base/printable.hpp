// SPDX-License-Identifier: MIT
// Names of files, sites and molecules from user input: escaped for the terminal, or rejected.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace polhode {

/// A text in which every control character (C0, DEL, C1) and every byte that is not UTF-8 is
/// written as \xNN. A terminal then displays the text without interpreting control sequences in it.
std::string printable(std::string_view text);

/// The number of characters in a UTF-8 text.
std::size_t character_count(std::string_view text);

/// Rejects a name with control characters or bytes that are not UTF-8, because names appear in
/// scripts, tables and terminals.
/// @param what  object that has the name, such as "the output"
/// @throws Error  with the name and the first such byte
void check_name(std::string_view what, std::string_view name);

}  // namespace polhode
