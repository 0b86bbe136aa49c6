// SPDX-License-Identifier: MIT
// The states at which properties are measured.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace polhode {

struct StatePoint {
  double temperature = 0;  ///< [K]
  double pressure = 0;     ///< [kJ/mol/nm³]

  /// "298.15 K, 1 bar".
  std::string text() const;
  /// "298.15K-1bar", for file names.
  std::string file_text() const;
};

/// The points of a text: "298.15 K, 1 bar", or with a range in place of either, "250 K to 320 K, 7
/// points". Without a pressure it is 1 bar.
/// @throws Error  naming what cannot be read
std::vector<StatePoint> state_points(std::string_view text);

}  // namespace polhode
