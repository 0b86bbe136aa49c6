// SPDX-License-Identifier: MIT
// A caller of a simulation, study, adviser or analysis uses these callbacks to follow the job and
// to end it. A front end shows the progress on a terminal, in a notebook or in a log.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "polhode/measure/energy.hpp"
#include "polhode/model/state.hpp"

namespace polhode {

/// The progress of a job.
struct Progress {
  std::string job;               ///< name of the job's current stage, such as "equilibrating"
  std::optional<double> done{};  ///< fraction of the work, 0 to 1; empty if its amount is unknown
  std::string detail{};          ///< item that is being processed, such as the name of a scheme;
                                 ///< may be empty
};

/// All callbacks are optional. An exception that a callback throws ends the job and is passed to
/// the caller of the job.
struct Callbacks {
  /// Called often and from any thread, but never by two threads at once.
  std::function<void(const Progress&)> progress{};
  /// Called often, from any thread, and possibly by several threads at once. If this callback
  /// returns true, the job ends soon with the results so far.
  std::function<bool()> stop{};
  /// Receives a line of text without a line end: a note on the input, or a description of the job's
  /// next stage.
  std::function<void(const std::string& text)> message{};
  /// Called at every energy sample of a simulation, with the number of steps done.
  std::function<void(std::size_t steps, const State& state, const Energies& energies)> sample{};

  void report(const Progress& now) const {
    if (progress) progress(now);
  }
  bool stopped() const { return stop && stop(); }
  void note(const std::string& text) const {
    if (message) message(text);
  }
};

}  // namespace polhode
