// SPDX-License-Identifier: MIT
// When the progress of a job is shown: on a terminal, and as a line in a log.
#pragma once

#include <atomic>
#include <cmath>
#include <optional>

namespace polhode {

/// A line at each tenth of a job, or a minute after the last line, whichever comes first; no two
/// within a second, so that short jobs have none.
class ProgressPace {
 public:
  /// Whether a line is due; if it is, it counts as written.
  /// @param done     fraction of the work, if its amount is known
  /// @param elapsed  since the job began [s]
  bool due(std::optional<double> done, double elapsed) {
    const double tenths = std::floor(10 * done.value_or(0) + 1e-9);
    const double since = elapsed - last_;
    if (since < 1 || (tenths <= tenths_ && since < 60)) return false;
    tenths_ = tenths;
    last_ = elapsed;
    return true;
  }

 private:
  double tenths_ = 0, last_ = 0;  // at the last line
};

/// Five times a second, and at once when all of the work is done.
class TerminalPace {
 public:
  /// Whether the line is due; if it is, it counts as written. The arguments are those of
  /// ProgressPace::due().
  bool due(std::optional<double> done, double elapsed) {
    const bool complete = done.value_or(0) >= 1;
    if (elapsed - last_ < 0.2 && (complete_ || !complete)) return false;
    complete_ = complete;
    last_ = elapsed;
    return true;
  }

 private:
  double last_ = -1;  // when the line was written
  bool complete_ = false;
};

/// Ten times a second for all threads together, without a lock: for reports after every step.
class SharedPace {
 public:
  /// Whether a report is due; for one of the threads that ask at the same time.
  /// @param elapsed  since the job began [s]
  bool due(double elapsed) {
    double next = next_.load(std::memory_order_relaxed);
    return elapsed >= next && next_.compare_exchange_strong(next, elapsed + interval);
  }

  static constexpr double interval = 0.1;  // [s]

 private:
  std::atomic<double> next_ = 0;
};

}  // namespace polhode
