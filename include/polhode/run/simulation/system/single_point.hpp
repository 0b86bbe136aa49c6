// SPDX-License-Identifier: MIT
// Energies, pressure, forces and torques of one configuration.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "polhode/base/vec3.hpp"
#include "polhode/model/state.hpp"
#include "polhode/run/callbacks.hpp"
#include "polhode/run/quantities.hpp"
#include "polhode/run/simulation/system/system.hpp"

namespace polhode {

struct SinglePoint {
  System system;
  Load load;
  /// Terms of the energy besides the sums over pairs within the cutoff, with their names [kJ/mol].
  std::vector<std::pair<std::string, double>> terms;
  Mat3<double> pressure_tensor;    ///< [bar]
  std::optional<Load> derivative;  ///< derivative of forces and torques, if requested

  double pressure() const;  ///< a third of the trace [bar]
};

/// Evaluates the forces at the initial configuration of a run file.
/// @param derivative  whether to evaluate that along the displacement (f/m, J⁻¹ Sτ) of the gradient
///                    kick as well
SinglePoint single_point(const Config& config, bool derivative = false,
                         const Callbacks& callbacks = {});

/// Energies and pressure as a list, from which text, JSON and the manual follow.
Quantities quantities(const SinglePoint& point);

}  // namespace polhode
