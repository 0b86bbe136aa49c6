// SPDX-License-Identifier: MIT
// Texts and file names in gnuplot scripts, quoted so that nothing in them is evaluated.
#pragma once

#include <string>
#include <string_view>

namespace polhode {

/// A text between single quotes, in which gnuplot replaces neither `commands` nor backslashes.
/// Characters that are not printable are escaped first, so that the text stays on one line.
std::string gnuplot_text(std::string_view text);

/// A file next to the script, quoted. It begins with "./", because gnuplot takes "<command"
/// and "|command" for pipes and "~" for a home folder.
std::string gnuplot_file(std::string_view path);

/// A text in a comment, on one line.
std::string gnuplot_comment(std::string_view text);

}  // namespace polhode
