// SPDX-License-Identifier: MIT
// Curves of a CSV file as a figure with panels.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace polhode {

/// The data of a figure with panels, in which columns of a CSV file are plotted against its first
/// column.
struct CurvesFigure {
  std::string csv;
  std::string title, x_label, y_label;
  double left = 0, right = 1;  ///< limits of the common horizontal axis
  std::size_t across = 0;      ///< panels in a row; 0 chooses as many as are readable
  struct Curve {
    std::string name;       ///< name in the legend; curves without a name are not in the legend
    std::size_t column;     ///< number of the column in the file, from 1
    std::size_t error = 0;  ///< column of the standard errors, drawn as a band; 0 for no band
  };
  /// A straight line between two points, such as a fit.
  struct Line {
    std::string name;
    std::array<double, 2> x, y;
  };
  struct Panel {
    std::string title;
    std::vector<Curve> curves;
    std::vector<Line> lines{};
    double low = 0, high = 1;  ///< limits of the vertical axis
  };
  std::vector<Panel> panels{};
};

}  // namespace polhode
