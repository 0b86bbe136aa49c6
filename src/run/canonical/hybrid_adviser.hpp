// SPDX-License-Identifier: MIT
// Finds the step and the number of steps per trajectory for which hybrid Monte Carlo gives the most
// independent samples per force evaluation.
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
  NamedScheme scheme = "hoa2";      ///< scheme of the proposals
  std::size_t evaluations = 5'000;  ///< number of force evaluations in each pilot run
  int runs = 4;                     ///< number of runs of each choice, from independent initial
                                    ///< configurations
  /// Number of finalists, and the length of their runs relative to pilot runs. Pilot runs are made
  /// for all choices of settings. The best choices (finalists) are run again with different random
  /// numbers, and these runs give the answer.
  std::size_t finalists = 3, longer = 8;
};

/// A step and a number of steps per trajectory, with the results of its runs.
struct HybridChoice {
  double step = 0;        ///< time step [ps]
  std::size_t steps = 1;  ///< number of steps per trajectory
  Estimate acceptance;    ///< acceptance rate [1]
  Estimate weight;        ///< mean of exp(−ΔH/kT), which must be 1 within its error
  /// Force evaluations per independent sample of U. The number is empty if the runs are too short
  /// to determine it, or if a run blew up.
  std::optional<Estimate> evaluations_per_sample;
};

struct HybridAdvice {
  std::string scheme;
  std::vector<HybridChoice> pilots;     ///< pilot choices, ordered by step, then by steps per
                                        ///< trajectory
  std::vector<HybridChoice> finalists;  ///< finalists, the cheapest first
  /// Finalists that are not distinguishable from the first finalist: the costs differ by less than
  /// two standard errors of the difference.
  std::vector<std::size_t> equal;
  bool stopped = false;
};

/// Sorts the finalists by cost, and finds the finalists that are not distinguishable from the
/// first.
void rank(HybridAdvice& advice);

/// Chooses the step and trajectory length of hybrid Monte Carlo for the system of a run file.
/// Results do not depend on the clock or on the number of threads.
/// @throws Error  under the same conditions as check_hybrid()
HybridAdvice advise_hybrid(const Config& config, const HybridAdviserSettings& settings = {},
                           const Callbacks& callbacks = {}, Workers& workers = Workers::serial());

/// The recommended settings in a sentence.
std::string answer(const HybridAdvice& advice);

/// The results of the search as a list, from which text, JSON and the manual are made.
Quantities quantities(const HybridAdvice& advice);

}  // namespace polhode
