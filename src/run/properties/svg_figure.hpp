// SPDX-License-Identifier: MIT
// A small line figure as SVG, for pages that need no other file.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace polhode {

struct SvgCurve {
  std::vector<double> x, y;
  std::vector<double> error{};  ///< half of the band about each point; empty: none
};

struct SvgFigure {
  std::string title, x_label, y_label;
  std::vector<SvgCurve> curves;
  std::vector<double> marks{};  ///< vertical lines at x
};

/// The element `svg` with its caption in a `figure`; empty without a finite point.
std::string svg(const SvgFigure& figure);

/// A text with the characters that have a meaning in HTML replaced.
std::string html(const std::string& text);

}  // namespace polhode
