// SPDX-License-Identifier: MIT
// A thread pool that shares the work of one loop: a fork and a join per call.
#pragma once

#include <cstddef>
#include <memory>

namespace polhode {

/// A fixed number of threads, including the calling thread. Between calls the other threads spin
/// for a few tens of µs, so that the next call costs only a µs or two. Idle threads then sleep and
/// leave the cores to other processes. If the system gives a thread no core, the thread takes no
/// work, and no other thread waits for it.
class Workers {
 public:
  /// @param threads  number of threads, at least 1; threads beyond allowed_threads() give no
  ///   speedup (base/threads.hpp)
  explicit Workers(int threads);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// A Workers object that uses only the calling thread.
  static Workers& serial();

  int threads() const { return threads_; }

  /// Calls task(k) once for every 0 ≤ k < count, in any order and on any thread, and returns when
  /// all are done. The caller then sees all data that the tasks have written. Does not allocate
  /// memory. A call from within a task, or during another thread's call, runs all its tasks on the
  /// calling thread.
  ///
  /// Each thread begins with a share of consecutive tasks, which is the same in each call with this
  /// count. Data that a task uses again is therefore often still in the cache of its core.
  ///
  /// If a task throws, later tasks that have not started are skipped, and the exception of the task
  /// with the smallest k is rethrown. A single thread would throw the same exception.
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
  std::unique_ptr<Pool> pool_;  // null for one thread
};

}  // namespace polhode
