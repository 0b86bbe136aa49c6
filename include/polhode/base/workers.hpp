// SPDX-License-Identifier: MIT
// A thread pool that shares the work of one loop: a fork and a join per call.
#pragma once

#include <cstddef>
#include <memory>

namespace polhode {

/// A fixed number of threads, including the calling one. Between calls the others spin for a few
/// tens of µs, so that the next call costs only a µs or two. Then they sleep and leave the cores
/// to other processes. A thread that gets no core takes no work, and no other thread waits for
/// it.
class Workers {
 public:
  /// @param threads  at least 1; more than the allowed cores gains nothing (base/threads.hpp)
  explicit Workers(int threads);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// The calling thread only.
  static Workers& serial();

  int threads() const { return threads_; }

  /// Calls task(k) once for every 0 ≤ k < count, in any order and on any thread, and returns when
  /// all are done. What the tasks have written is then visible to the caller. Does not allocate.
  /// Called from within a task, or while another thread's call is in progress, it runs all tasks on
  /// the calling thread.
  ///
  /// If a task throws, tasks not yet started are skipped, and the exception of the smallest k is
  /// rethrown here. Tasks start in order, so a single thread would have thrown the same exception
  /// first.
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
