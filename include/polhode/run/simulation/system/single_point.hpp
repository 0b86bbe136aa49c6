// SPDX-License-Identifier: MIT
// Energies, pressure, forces and torques of one configuration.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "polhode/base/vec3.hpp"
#include "polhode/run/callbacks.hpp"
#include "polhode/run/quantities.hpp"
#include "polhode/run/simulation/system/system.hpp"

namespace polhode {

struct SinglePoint {
  System system;
  Load load;
  /// Names and values of the energy terms other than the sums over pairs within the cutoff
  /// [kJ/mol].
  std::vector<std::pair<std::string, double>> terms;
  Mat3<double> pressure_tensor;    ///< pressure tensor [bar]
  std::optional<Load> derivative;  ///< derivative of forces and torques, if requested

  double pressure() const;  ///< Pressure: a third of the trace of the pressure tensor [bar].
};

/// Evaluates the forces at the initial configuration of a run file.
/// @param derivative  whether to evaluate also the derivative of the forces along the displacement
///   (f/m, J⁻¹ Sτ) of a gradient kick
SinglePoint single_point(const Config& config, bool derivative = false,
                         const Callbacks& callbacks = {});

/// The energies and the pressure as a list, from which text, JSON and the manual are made.
Quantities quantities(const SinglePoint& point);

}  // namespace polhode
