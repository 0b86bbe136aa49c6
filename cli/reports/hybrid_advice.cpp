// SPDX-License-Identifier: MIT
#include "hybrid_advice.hpp"

#include <fmt/core.h>

#include <string>
#include <vector>

#include "../terminal/console.hpp"
#include "../terminal/streams.hpp"
#include "polhode/base/error.hpp"
#include "reports.hpp"

namespace polhode::cli {
int advise_hybrid(const HybridAdviserSettings& settings, const Config& config, bool json,
                  Workers& workers) {
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
