// SPDX-License-Identifier: MIT
// Texts and file names quoted for gnuplot's scripts, so that nothing in them is evaluated.
#pragma once

#include <string>
#include <string_view>

namespace polhode {

/// A text between single quotes: in these gnuplot replaces neither `commands` nor backslashes. What
/// is not printable is escaped first, so that the text stays one line.
std::string gnuplot_text(std::string_view text);

/// A file in the folder of the script, quoted. It begins with "./", as gnuplot would take
/// "<command" and
/// "|command" for pipes and "~" for a home.
std::string gnuplot_file(std::string_view path);

/// A text in a comment, which stays in its line.
std::string gnuplot_comment(std::string_view text);

}  // namespace polhode
