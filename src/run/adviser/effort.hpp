// SPDX-License-Identifier: MIT
// The progress of a job with an amount of work that is not known at the start.
#pragma once

#include <algorithm>
#include <atomic>

namespace polhode {

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
