// SPDX-License-Identifier: MIT
// Texts and file names in gnuplot scripts, quoted so that nothing in them is evaluated.
#pragma once

#include <string>
#include <string_view>

namespace polhode {

/// Quotes a text with single quotes, in which gnuplot replaces neither `commands` nor backslashes.
/// Unprintable characters are escaped before quoting, so that the text stays on one line.
std::string gnuplot_text(std::string_view text);

/// Quotes the name of a file next to the script. The result begins with "./", because gnuplot
/// interprets "<command" and "|command" as pipes and "~" as a home folder.
std::string gnuplot_file(std::string_view path);

/// Writes a text as a comment on one line.
std::string gnuplot_comment(std::string_view text);

}  // namespace polhode
