// SPDX-License-Identifier: MIT
// A small line figure as SVG, for pages that need no other file.
#pragma once

#include <string>
#include <vector>

namespace polhode {

struct SvgCurve {
  std::vector<double> x, y;
  std::vector<double> error{};  ///< half-width of the error band at each point; empty if there is
                                ///< no band
};

struct SvgFigure {
  std::string title, x_label, y_label;
  std::vector<SvgCurve> curves;
  std::vector<double> marks{};  ///< x positions of vertical lines
  bool from_zero = true;        ///< whether the axis of x begins at zero
};

/// The figure as an `svg` element with its caption, in a `figure` element. It is empty if no point
/// is finite.
std::string svg(const SvgFigure& figure);

/// Escapes the special characters of HTML in a text.
std::string html(const std::string& text);

}  // namespace polhode
