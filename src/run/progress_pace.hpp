// SPDX-License-Identifier: MIT
// The progress of a job: when it is shown, on a terminal or as lines in a log, and the fraction
// done of an amount of work that is not known at the start.
#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>

namespace polhode {

/// The pace of progress lines in files: a line after each 10 % of a job, or a minute after the last
/// line, whichever comes first. Lines are at least a second apart, so that short jobs write no
/// lines.
class ProgressPace {
 public:
  /// Whether a line is due. If a line is due, the caller must write the line.
  /// @param done     fraction of the work that is done, if it is known
  /// @param elapsed  time since the job began [s]
  bool due(std::optional<double> done, double elapsed) {
    const double tenths = std::floor(10 * done.value_or(0) + 1e-9);
    const double since = elapsed - last_;
    if (since < 1 || (tenths <= tenths_ && since < 60)) return false;
    tenths_ = tenths;
    last_ = elapsed;
    return true;
  }

 private:
  double tenths_ = 0, last_ = 0;  // progress and time at the last line
};

/// The pace of the progress line on a terminal: five times a second, and immediately when all of
/// the work is done.
class TerminalPace {
 public:
  /// Whether the line is due. If the line is due, the caller must write the line. The arguments are
  /// those of ProgressPace::due().
  bool due(std::optional<double> done, double elapsed) {
    const bool complete = done.value_or(0) >= 1;
    if (elapsed - last_ < 0.2 && (complete_ || !complete)) return false;
    complete_ = complete;
    last_ = elapsed;
    return true;
  }

 private:
  double last_ = -1;  // time at which the last line was written [s]
  bool complete_ = false;
};

/// The pace of reports after every step: ten times a second for all threads together, without a
/// lock.
class SharedPace {
 public:
  /// Whether a report is due. If several threads call this function at the same time, only one
  /// thread receives true.
  /// @param elapsed  time since the job began [s]
  bool due(double elapsed) {
    double next = next_.load(std::memory_order_relaxed);
    return elapsed >= next && next_.compare_exchange_strong(next, elapsed + interval);
  }

  static constexpr double interval = 0.1;  // interval between reports [s]

 private:
  std::atomic<double> next_ = 0;
};

/// The work done and the work still expected, in any unit, such as force evaluations. Any thread
/// may add work.
class Effort {
 public:
  void add(double work) {
    double before = done();
    while (!done_.compare_exchange_weak(before, before + work, std::memory_order_relaxed)) {
    }
  }
  /// Replaces the work that is still expected. The fraction done may decrease, for example when a
  /// step is rejected and another step is tried.
  void expect(double left) { planned_.store(done() + left, std::memory_order_relaxed); }

  double done() const { return done_.load(std::memory_order_relaxed); }
  /// The fraction of the work that is done. The fraction is 0 if no work is expected, and below 1
  /// until all expected work is done.
  double fraction() const {
    const double planned = planned_.load(std::memory_order_relaxed);
    return planned > 0 ? std::min(1.0, done() / planned) : 0;
  }

 private:
  std::atomic<double> done_ = 0, planned_ = 0;
};

}  // namespace polhode
