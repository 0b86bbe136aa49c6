// SPDX-License-Identifier: MIT
// Minimises the energy of a run file's initial configuration and writes the result.
#pragma once

#include <string>

#include "polhode/ensemble/minimise.hpp"
#include "polhode/io/settings/config.hpp"
#include "polhode/run/callbacks.hpp"
#include "polhode/run/outputs.hpp"
#include "polhode/run/quantities.hpp"

namespace polhode {

struct MinimisationReport {
  Minimisation minimisation;
  std::size_t molecules = 0;
  MinimisationSettings settings;
  std::string file;  ///< the configuration at the end, without velocities
};

/// Minimises, and writes PREFIX-minimised.gro, also if it is interrupted or ends at the maximum
/// number of steps. Overlapping molecules are allowed.
/// @throws Error     if a setting or the initial configuration does not fit, or outputs exist
/// @throws RunError  naming two molecules, if a force is not finite
MinimisationReport minimise_configuration(const Config& config,
                                          const MinimisationSettings& settings = {},
                                          const OutputOptions& options = {},
                                          const Callbacks& callbacks = {},
                                          Workers& workers = Workers::serial());

/// "converged", "maximum number of steps" or "interrupted".
std::string reason(MinimisationEnd end);

/// The results as a list, from which text, JSON and the manual follow.
Quantities quantities(const MinimisationReport& report);

}  // namespace polhode
