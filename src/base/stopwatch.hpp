// SPDX-License-Identifier: MIT
// Elapsed time, always measured by a monotonic clock.
#pragma once

#include <chrono>

namespace polhode {

/// Measures the time since construction or since the last lap.
class Stopwatch {
 public:
  /// Time since the construction or the last lap [s].
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  /// Time since the last lap [s]; starts a new lap, so that consecutive laps add up to the whole
  /// time.
  double lap() {
    const Clock::time_point now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - start_).count();
    start_ = now;
    return seconds;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

/// The time [s] that work() takes.
template <class Work>
double seconds_of(const Work& work) {
  const Stopwatch watch;
  work();
  return watch.seconds();
}

}  // namespace polhode
