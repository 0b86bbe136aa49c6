// SPDX-License-Identifier: MIT
// Which scheme and step meet the user's requirement at the minimum cost: short runs of the user's
// system show which steps are candidates, the clock shows what they cost, and independent runs
// confirm the answer.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "polhode/base/workers.hpp"
#include "polhode/integrate/scheme.hpp"
#include "polhode/io/settings/config.hpp"
#include "polhode/run/adviser/criterion.hpp"
#include "polhode/run/adviser/step_model.hpp"
#include "polhode/run/callbacks.hpp"

namespace polhode {

struct AdviserSettings {
  Criterion criterion;
  std::vector<NamedScheme> schemes;  ///< candidates
  double seconds = 60;               ///< approximate wall-clock time of the whole search
};

/// What is known of a scheme.
struct Candidate {
  std::string name;  ///< or its text
  Scheme scheme;
  std::vector<AdviserPoint> points;  ///< points by growing step
  std::optional<StepModel> model;    ///< model of R, if R is required
  double step = 0;                   ///< expected to meet the bound [ps]; 0: there is none
  double seconds = 0;                ///< wall-clock time of a simulated ps with that step
  std::string obstacle;              ///< why there is no step

  double ns_per_day() const { return seconds > 0 ? 86.4 / seconds : 0; }
};

struct Advice {
  std::vector<Candidate> candidates;
  std::optional<std::size_t> best;       ///< a confirmed one
  std::optional<std::size_t> runner_up;  ///< the cheapest of the others, by estimate
  AdviserPoint confirmation;             ///< independent runs of the best one
  std::vector<std::pair<std::size_t, AdviserPoint>> refused;  ///< runs that did not confirm a step
  /// Runs that met the requirement with such a margin that a longer step was tried instead.
  std::vector<std::pair<std::size_t, AdviserPoint>> surpassed;
  bool stopped = false;
};

/// Advice for the run of a run file, from runs that begin with its initial configuration after its
/// equilibration. They have its length if the time allows, otherwise a shorter one; each worker
/// performs one at a time. Results depend on the clock, which limits the lengths of runs and
/// measures what schemes cost.
Advice advise(const Config& config, const AdviserSettings& settings,
              const Callbacks& callbacks = {}, Workers& workers = Workers::serial());

}  // namespace polhode
