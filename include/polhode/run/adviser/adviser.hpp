// SPDX-License-Identifier: MIT
// The adviser finds the scheme and step that meet the user's requirement at the minimum cost. Short
// runs of the user's system determine candidate steps, timings give the costs, and independent runs
// confirm the answer.
#pragma once

#include <optional>
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
  std::vector<NamedScheme> schemes;  ///< candidate schemes
  double seconds = 60;               ///< approximate wall-clock time of the whole search
};

/// The results for one candidate scheme.
struct Candidate {
  std::string name;  ///< name of the scheme, or its text
  Scheme scheme;
  std::vector<AdviserPoint> points;  ///< measured points in the order of increasing step
  std::optional<StepModel> model;    ///< model of R; empty if a bias is bounded instead of R
  double step = 0;                   ///< step that is expected to meet the bound [ps]; 0 if there
                                     ///< is none
  double seconds = 0;                ///< wall-clock time per simulated ps at this step [s]
  std::string obstacle;              ///< reason why no time step meets the required bound

  double ns_per_day() const { return seconds > 0 ? 86.4 / seconds : 0; }
};

struct Advice {
  std::vector<Candidate> candidates;
  std::optional<std::size_t> best;       ///< index of the confirmed best candidate
  std::optional<std::size_t> runner_up;  ///< index of the candidate with the lowest estimated cost,
                                         ///< other than `best`
  AdviserPoint confirmation;             ///< independent runs of the best candidate
  std::vector<std::pair<std::size_t, AdviserPoint>> refused;  ///< candidates and runs that did not
                                                              ///< confirm a step
  /// Candidates and runs that met the requirement by a large margin, so that a longer step was
  /// tried.
  std::vector<std::pair<std::size_t, AdviserPoint>> surpassed;
  bool stopped = false;
};

/// Chooses a scheme and a step for a run file by test runs. The test runs start from the
/// equilibrated initial configuration of the run file. Test runs have the length of the run file's
/// trajectory if the time allows, and are otherwise shorter. Each worker performs one test run at a
/// time. Results depend on wall-clock time, which limits the lengths of test runs and measures the
/// cost of schemes.
Advice advise(const Config& config, const AdviserSettings& settings,
              const Callbacks& callbacks = {}, Workers& workers = Workers::serial());

}  // namespace polhode
