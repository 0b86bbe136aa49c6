// SPDX-License-Identifier: MIT
// Colours and markers of schemes, the same in all figures.
#pragma once

#include <string>
#include <vector>

namespace polhode {

/// The style in which a scheme is drawn.
struct SchemeStyle {
  std::string colour;        ///< colour as "#RRGGBB"
  int filled = 7, open = 6;  ///< point types of gnuplot
};

/// The styles of the schemes of a figure, from data/plots/schemes.toml. Schemes that are not in
/// schemes.toml, such as schemes written as text, get the unused styles in order.
std::vector<SchemeStyle> scheme_styles(const std::vector<std::string>& schemes);

}  // namespace polhode
