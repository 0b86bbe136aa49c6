// SPDX-License-Identifier: MIT
// Colours and markers of schemes, the same in all figures.
#pragma once

#include <string>
#include <vector>

namespace polhode {

/// How a scheme is drawn.
struct SchemeStyle {
  std::string colour;        ///< "#RRGGBB"
  int filled = 7, open = 6;  ///< point types of gnuplot
};

/// The styles of the schemes of a figure: those of data/plots/schemes.toml; schemes that it does
/// not name, such as those written as text, get its other styles in order.
std::vector<SchemeStyle> scheme_styles(const std::vector<std::string>& schemes);

}  // namespace polhode
