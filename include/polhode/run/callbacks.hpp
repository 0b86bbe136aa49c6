// SPDX-License-Identifier: MIT
// What the caller of a simulation, study, adviser or analysis may see and decide along the way. A
// front end shows it: on a terminal, in a notebook, in a log.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "polhode/measure/energy.hpp"
#include "polhode/model/state.hpp"

namespace polhode {

/// How far a job has come.
struct Progress {
  std::string job;               ///< "equilibrating"
  std::optional<double> done{};  ///< fraction of the work, 0 to 1; empty if its amount is unknown
  std::string detail{};          ///< what is being done, such as a scheme's name; may be empty
};

/// All callbacks are optional. An exception that one of them throws ends the job and reaches its
/// caller.
struct Callbacks {
  /// Called often, by any thread, but by one at a time.
  std::function<void(const Progress&)> progress{};
  /// Called often, by any thread, by several at a time: true ends the job soon, with the results so
  /// far.
  std::function<bool()> stop{};
  /// A line of text, without line end: a note on the input, or what the job does next.
  std::function<void(const std::string& text)> message{};
  /// Called at every sample of the energies of a simulation, with the number of steps done.
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
