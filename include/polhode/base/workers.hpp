// SPDX-License-Identifier: MIT
// Threads that share the work of one loop: a fork and a join for each call.
#pragma once

#include <cstddef>
#include <memory>

namespace polhode {

/// A fixed number of threads, the calling one among them. Between calls the others wait: for some
/// ten µs awake, so that the next call costs a µs or two, then asleep, so that a process beside
/// this one has the cores. A thread that gets no core joins no work, and nobody waits for it.
class Workers {
 public:
  /// @param threads  at least 1; more than the cores allowed gains nothing (base/threads.hpp)
  explicit Workers(int threads);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// The calling thread alone.
  static Workers& serial();

  int threads() const { return threads_; }

  /// Calls task(k) once for every 0 ≤ k < count, in any order and on any thread, and returns when
  /// all are done. What the tasks wrote is then visible to the caller. No allocation. From within a
  /// task, or while another thread's call is under way, the calling thread does all of it alone.
  ///
  /// If a task throws, those not yet begun are left out, and what the smallest k threw is thrown
  /// here: tasks begin in order, so it is what one thread alone would have met first.
  template <class Task>
  void each(std::size_t count, const Task& task) {
    if (count > 1 && threads_ > 1)
      fork({[](const void* t, std::size_t k) { (*static_cast<const Task*>(t))(k); }, &task, count});
    else
      for (std::size_t k = 0; k < count; ++k) task(k);
  }

 private:
  struct Work {
    void (*call)(const void* task, std::size_t k) = nullptr;
    const void* task = nullptr;
    std::size_t count = 0;
  };
  class Pool;

  void fork(const Work& work);

  int threads_;
  std::unique_ptr<Pool> pool_;  // none for one thread
};

}  // namespace polhode
