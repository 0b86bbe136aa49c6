// SPDX-License-Identifier: MIT
#include "hybrid_advice.hpp"

#include <fmt/core.h>

#include <cmath>
#include <string>
#include <vector>

#include "../options/option_values.hpp"
#include "../terminal/console.hpp"
#include "../terminal/streams.hpp"
#include "io/files/with_error.hpp"
#include "io/settings/output_units.hpp"
#include "polhode/base/error.hpp"

namespace polhode::cli {
namespace {

void print_choices(const char* title, const std::vector<HybridChoice>& choices) {
  fmt::print("{}\n{:>8} {:>6} {:>13} {:>20} {:>20}\n", title, "step fs", "steps", "acceptance %",
             "<exp(-dH/kT)>", "evaluations/sample");
  for (const HybridChoice& c : choices) {
    if (!std::isfinite(c.weight.value)) {
      fmt::print("{:>8.3g} {:>6} {:>13}\n", c.step * units::fs_per_ps, c.steps, "a run blew up");
      continue;
    }
    const auto& cost = c.evaluations_per_sample;
    fmt::print("{:>8.3g} {:>6} {:>13.1f} {:>20} {:>20}\n", c.step * units::fs_per_ps, c.steps,
               100 * c.acceptance.value, with_error(c.weight.value, c.weight.error),
               cost ? with_error(cost->value, cost->error) : "-");
  }
}

void print_advice(const HybridAdvice& advice) {
  print_choices("pilot runs", advice.pilots);
  print_choices("\nindependent, longer runs of the best", advice.finalists);
  if (!advice.finalists.empty()) fmt::print("\n{}\n", answer(advice));
}

}  // namespace

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
                  const std::vector<std::string>& schemes, bool json, Workers& workers) {
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
  if (json)
    fmt::print("{}\n", hybrid_advice_json(advice));
  else
    print_advice(advice);
  if (advice.finalists.empty()) throw RunError(answer(advice));
  return 0;
}

}  // namespace polhode::cli
