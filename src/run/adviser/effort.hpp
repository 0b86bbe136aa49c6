// SPDX-License-Identifier: MIT
// How far a job has come whose work becomes known only as it proceeds.
#pragma once

#include <algorithm>
#include <atomic>

namespace polhode {

/// Work done and still expected, in any unit, such as force evaluations. Work may be added by any
/// thread.
class Effort {
 public:
  void add(double work) {
    double before = done();
    while (!done_.compare_exchange_weak(before, before + work, std::memory_order_relaxed)) {
    }
  }
  /// Replaces the work that is still expected: the fraction may become smaller, as when a step is
  /// rejected and another one is tried.
  void expect(double left) { planned_.store(done() + left, std::memory_order_relaxed); }

  double done() const { return done_.load(std::memory_order_relaxed); }
  /// 0 while nothing is expected; below 1 until all that is expected is done.
  double fraction() const {
    const double planned = planned_.load(std::memory_order_relaxed);
    return planned > 0 ? std::min(1.0, done() / planned) : 0;
  }

 private:
  std::atomic<double> done_ = 0, planned_ = 0;
};

}  // namespace polhode
