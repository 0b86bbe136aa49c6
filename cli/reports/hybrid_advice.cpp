// SPDX-License-Identifier: MIT
#include "hybrid_advice.hpp"

#include <fmt/core.h>

#include <string>
#include <vector>

#include "../options/option_values.hpp"
#include "../terminal/console.hpp"
#include "../terminal/streams.hpp"
#include "polhode/base/error.hpp"
#include "reports.hpp"

namespace polhode::cli {
void HybridAdviceOptions::declare(Command& command) {
  command.add_option("--ensemble", ensemble,
                     "nvt: step and trajectory length of hybrid Monte Carlo; default: nve");
  command
      .add_option("--evaluations", evaluations,
                  "with --ensemble nvt: force evaluations of each pilot run")
      .in_range(100, 100'000'000)
      .show_default();
}

bool HybridAdviceOptions::chosen() const {
  return !ensemble.empty() &&
         named_option<StudyEnsemble>(ensemble, "--ensemble") == StudyEnsemble::nvt;
}

int advise_hybrid(const HybridAdviceOptions& options, const Config& config,
                  const std::vector<NamedScheme>& schemes, bool json, Workers& workers) {
  HybridAdviserSettings settings;
  settings.evaluations = static_cast<std::size_t>(options.evaluations);
  if (!schemes.empty()) settings.scheme = schemes.front();
  if (schemes.size() > 1)
    throw Error("--schemes names several schemes; hybrid Monte Carlo is advised for one at a time");
  const HybridAdvice advice = polhode::advise_hybrid(config, settings, console(), workers);
  if (advice.stopped) {
    log("interrupted before the search ended\n");
    return 130;
  }
  print_results(quantities(advice), json);
  if (advice.finalists.empty()) throw RunError(answer(advice));
  return 0;
}

}  // namespace polhode::cli
