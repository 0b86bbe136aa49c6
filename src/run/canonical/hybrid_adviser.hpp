// SPDX-License-Identifier: MIT
// Which step, and how many steps per trajectory, give hybrid Monte Carlo the most independent
// samples per force evaluation.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "polhode/base/workers.hpp"
#include "polhode/io/settings/config.hpp"
#include "polhode/math/fit.hpp"
#include "polhode/run/callbacks.hpp"
#include "polhode/run/quantities.hpp"

namespace polhode {

struct HybridAdviserSettings {
  NamedScheme scheme = "hoa2";      ///< of the proposals
  std::size_t evaluations = 5'000;  ///< of the forces, in each pilot run
  int runs = 4;                     ///< from independent initial configurations, of each choice
  /// Pilot runs are of all choices; runs of the best ones, this many times longer and with other
  /// random numbers, give the answer.
  std::size_t finalists = 3, longer = 8;
};

/// A step and a number of steps per trajectory, with what its runs show.
struct HybridChoice {
  double step = 0;        ///< [ps]
  std::size_t steps = 1;  ///< per trajectory
  Estimate acceptance;    ///< [1]
  Estimate weight;        ///< mean of exp(−ΔH/kT), 1 within its error
  /// Force evaluations per independent sample of U; nothing if its runs are too short to tell, or
  /// if one blew up.
  std::optional<Estimate> evaluations_per_sample;
};

struct HybridAdvice {
  std::string scheme;
  std::vector<HybridChoice> pilots;     ///< by step, then by steps per trajectory
  std::vector<HybridChoice> finalists;  ///< the cheapest first
  /// Finalists that are not distinguishable from the first: their costs differ by less than two
  /// standard errors of the difference.
  std::vector<std::size_t> equal;
  bool stopped = false;
};

/// Sorts finalists by cost and finds those that are not distinguishable from the first.
void rank(HybridAdvice& advice);

/// Advice for the system of a run file. Results do not depend on the clock or on the number of
/// threads.
/// @throws Error  as check_hybrid()
HybridAdvice advise_hybrid(const Config& config, const HybridAdviserSettings& settings = {},
                           const Callbacks& callbacks = {}, Workers& workers = Workers::serial());

/// The answer in a sentence.
std::string answer(const HybridAdvice& advice);

/// The results as a list, from which text, JSON and the manual follow.
Quantities quantities(const HybridAdvice& advice);

}  // namespace polhode
