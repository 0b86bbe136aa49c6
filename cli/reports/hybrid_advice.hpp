// SPDX-License-Identifier: MIT
// polhode advise --ensemble nvt: advice for hybrid Monte Carlo, which has no bias to bound.
#pragma once

#include <string>
#include <vector>

#include "../options/command.hpp"
#include "run/canonical/hybrid_adviser.hpp"

namespace polhode::cli {

/// The options of polhode advise that concern the canonical ensemble.
struct HybridAdviceOptions {
  std::string ensemble;
  int evaluations = static_cast<int>(HybridAdviserSettings{}.evaluations);

  void declare(Command& command);
  /// Whether hybrid Monte Carlo is asked for.
  /// @throws Error  naming the option, for an unknown ensemble
  bool chosen() const;
};

/// Finds the step and the trajectory length, and prints them.
/// @param schemes  of the proposals: one, or none for the default
/// @return  the exit code
/// @throws Error     as advise_hybrid(), or if there are several schemes
/// @throws RunError  if no choice has runs long enough
int advise_hybrid(const HybridAdviceOptions& options, const Config& config,
                  const std::vector<NamedScheme>& schemes, bool json, Workers& workers);

}  // namespace polhode::cli
