// SPDX-License-Identifier: MIT
#include "polhode/base/workers.hpp"

#include <hwy/cache_control.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <limits>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "base/stopwatch.hpp"

#ifdef __linux__
#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace polhode {
namespace {

void pause() {
#if defined(__aarch64__)
  asm volatile("yield");
#else
  hwy::Pause();
#endif
}

/// Spins until `done` holds, for at most 30 µs. This time is several times the cost of putting a
/// thread to sleep and waking it. Spinning takes little time from other processes on the core.
template <class Done>
bool spin(const Done& done) {
  constexpr double max_spin = 30e-6;  // longest time of spinning [s]
  constexpr int pauses = 16;          // number of pauses between two readings of the clock
  const Stopwatch watch;
  do {
    for (int n = 0; n < pauses; ++n) {
      if (done()) return true;
      pause();
    }
  } while (watch.seconds() < max_spin);
  return done();
}

/// Threads can sleep until this number changes.
struct Futex {
  std::atomic<std::uint32_t> value{0};
  std::atomic<int> sleepers{0};

  /// Sleeps while the value is `old`; may return early.
  void sleep_while(std::uint32_t old) {
#ifdef __linux__
    sleepers.fetch_add(1);
    syscall(SYS_futex, &value, FUTEX_WAIT_PRIVATE, old, nullptr, nullptr, 0);
    sleepers.fetch_sub(1);
#else
    value.wait(old);
#endif
  }

  /// Wakes sleeping threads. Change the value by a sequentially consistent operation before this
  /// call, so that no sleeping thread misses the change.
  void wake(std::size_t max_wake) {
#ifdef __linux__
    constexpr std::size_t all = std::numeric_limits<int>::max();
    if (sleepers.load() > 0)
      syscall(SYS_futex, &value, FUTEX_WAKE_PRIVATE, static_cast<int>(std::min(max_wake, all)),
              nullptr, nullptr, 0);
#else
    if (max_wake > 0) value.notify_all();
#endif
  }
};

/// The time for which a thread has had its core. If the scheduler takes the core away within a
/// task, all other threads wait for the end of this task. A thread that often offers its core
/// between tasks is rarely interrupted within one. An offer costs less than a microsecond if no
/// other process wants the core.
class TimeSlice {
 public:
  void offer_core_if_long() {
    constexpr double max_run = 1e-3;  // below the time slices of schedulers [s]
    constexpr double max_gap = 1e-3;  // after a longer gap, another process had the core [s]
    const double now = watch_.seconds();
    if (now - last_ > max_gap) begin_ = now;
    last_ = now;
    if (now - begin_ < max_run) return;
    std::this_thread::yield();
    begin_ = last_ = watch_.seconds();
  }

 private:
  Stopwatch watch_;
  double begin_ = 0, last_ = 0;
};

// The gate is an atomic integer with three parts: whether there is work, how many pool threads are
// inside, and the number of the call. A thread joins by a compare-and-exchange of the whole
// integer. This exchange succeeds only while the gate is open. Once the gate is closed and no
// thread is inside, the work belongs to the caller again. The call counter wraps around, so a
// thread that slept through exactly 2¹⁶ calls misses the next call.
using Gate = std::uint32_t;
constexpr Gate over = 1, open = 2, one_inside = 4, one_call = Gate{1} << 16;
constexpr Gate inside(Gate gate) { return gate / one_inside % (one_call / one_inside); }
constexpr Gate call_of(Gate gate) { return gate / one_call; }

/// The tasks that one thread runs first, in order. Other threads take tasks from this share when
/// their own share is empty. A thread has the same share in each call with this number of tasks, so
/// data that it used before is often still in the cache of its core.
struct alignas(64) Share {
  std::atomic<std::size_t> next{0};
  std::size_t end = 0;
};

}  // namespace

class Workers::Pool {
 public:
  explicit Pool(int others) : shares_(static_cast<std::size_t>(others) + 1) {
    threads_.reserve(static_cast<std::size_t>(others));
    try {
      for (std::size_t n = 1; n < shares_.size(); ++n)
        threads_.emplace_back([this, n] { wait_and_work(n); });
    } catch (...) {
      end();
      throw;
    }
  }
  ~Pool() { end(); }

  void run(const Work& work) {
    if (busy_.exchange(true, std::memory_order_acquire)) {  // within a task or another call
      for (std::size_t k = 0; k < work.count; ++k) work.call(work.task, k);
      return;
    }
    work_ = work;
    for (std::size_t n = 0; n < shares_.size(); ++n) {
      shares_[n].next.store(work.count * n / shares_.size(), std::memory_order_relaxed);
      shares_[n].end = work.count * (n + 1) / shares_.size();
    }
    const Gate call = call_of(gate_.value.load(std::memory_order_relaxed)) + 1;
    gate_.value.store(call * one_call | open);
    gate_.wake(work.count - 1);
    take(0);
    if (inside(gate_.value.fetch_and(~open, std::memory_order_acq_rel)) > 0) wait_for_the_last();
    const std::exception_ptr thrown = std::exchange(thrown_, nullptr);
    thrown_by_.store(none, std::memory_order_relaxed);
    busy_.store(false, std::memory_order_release);
    if (thrown) std::rethrow_exception(thrown);
  }

 private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  /// Runs tasks until no tasks are left, at first the tasks in the share of the thread.
  void take(std::size_t thread) {
    const Work work = work_;
    for (std::size_t n = 0; n < shares_.size(); ++n) {
      Share& share = shares_[(thread + n) % shares_.size()];
      if (share.next.load(std::memory_order_relaxed) >= share.end) continue;
      for (std::size_t k; (k = share.next.fetch_add(1, std::memory_order_relaxed)) < share.end;)
        if (k < thrown_by_.load(std::memory_order_relaxed)) run_task(work, k);
    }
  }

  void run_task(const Work& work, std::size_t k) {
    try {
      work.call(work.task, k);
    } catch (...) {
      const std::lock_guard lock(throwing_);
      if (k > thrown_by_.load(std::memory_order_relaxed)) return;
      thrown_ = std::current_exception();
      thrown_by_.store(k, std::memory_order_relaxed);
    }
  }

  void wait_for_the_last() {
    const auto all_left = [this] {
      return inside(gate_.value.load(std::memory_order_acquire)) == 0;
    };
    if (spin(all_left)) return;
    for (;;) {
      const std::uint32_t seen = ended_.value.load(std::memory_order_acquire);
      if (all_left()) return;
      ended_.sleep_while(seen);
    }
  }

  /// Main loop of a pool thread.
  void wait_and_work(std::size_t thread) {
    Gate done = 0;  // the last call in which this thread took part
    TimeSlice slice;
    for (;;) {
      Gate gate = 0;
      const auto called = [&] {
        gate = gate_.value.load(std::memory_order_acquire);
        return (gate & over) != 0 || ((gate & open) != 0 && call_of(gate) != done);
      };
      while (!spin(called)) gate_.sleep_while(gate);
      if (gate & over) return;
      if (!gate_.value.compare_exchange_weak(gate, gate + one_inside, std::memory_order_acq_rel,
                                             std::memory_order_relaxed))
        continue;
      done = call_of(gate);
      take(thread);
      const Gate left = gate_.value.fetch_sub(one_inside, std::memory_order_acq_rel) - one_inside;
      if ((left & open) == 0 && inside(left) == 0) {
        ended_.value.fetch_add(1);
        ended_.wake(1);
      }
      slice.offer_core_if_long();
    }
  }

  void end() {
    gate_.value.fetch_or(over);
    gate_.wake(threads_.size());
    for (std::thread& thread : threads_) thread.join();
  }

  alignas(64) Futex gate_;  // in one cache line with the work, which a thread reads next
  Work work_;
  alignas(64) Futex ended_;  // number of calls that were closed before their last thread left
  std::atomic<bool> busy_{false};
  std::mutex throwing_;
  std::exception_ptr thrown_;
  std::atomic<std::size_t> thrown_by_{none};  // the first task that has thrown
  std::vector<Share> shares_;
  std::vector<std::thread> threads_;
};

Workers::Workers(int threads) : threads_(std::max(1, threads)) {
  if (threads_ > 1) pool_ = std::make_unique<Pool>(threads_ - 1);
}

Workers::~Workers() = default;

Workers& Workers::serial() {
  static Workers one(1);
  return one;
}

void Workers::fork(const Work& work) { pool_->run(work); }

}  // namespace polhode
