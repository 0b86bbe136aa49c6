// SPDX-License-Identifier: MIT
#include "hybrid_advice_report.hpp"

#include <fmt/core.h>

#include <cmath>
#include <string>
#include <vector>

#include "polhode/io/output_units.hpp"
#include "polhode/io/with_error.hpp"

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

}  // namespace

void print_hybrid_advice(const HybridAdvice& advice) {
  print_choices("pilot runs", advice.pilots);
  print_choices("\nindependent, longer runs of the best", advice.finalists);
  if (!advice.finalists.empty()) fmt::print("\n{}\n", answer(advice));
}

}  // namespace polhode::cli
