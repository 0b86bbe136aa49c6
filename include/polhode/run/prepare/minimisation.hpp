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
  std::string file;  ///< path of the final configuration, without velocities
};

/// Minimises the energy of a configuration and writes it to PREFIX-minimised.gro. The file is also
/// written if the minimisation is interrupted or reaches the maximum number of steps. The initial
/// configuration may have overlapping molecules.
/// @throws Error     if a setting or the initial configuration is invalid, or outputs exist
/// @throws RunError  if a force is not finite; the message names two molecules
MinimisationReport minimise_configuration(const Config& config,
                                          const MinimisationSettings& settings = {},
                                          const OutputOptions& options = {},
                                          const Callbacks& callbacks = {},
                                          Workers& workers = Workers::serial());

/// The reason why a minimisation ended: "converged", "maximum number of steps" or "interrupted".
std::string reason(MinimisationEnd end);

/// The results of a minimisation as a list, from which text, JSON and the manual are made.
Quantities quantities(const MinimisationReport& report);

}  // namespace polhode
