// SPDX-License-Identifier: MIT
// Workers perform each task once, for any number of threads; more threads than cores are allowed
// here, but slow.
#include "polhode/base/workers.hpp"

#include <doctest/doctest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using namespace polhode;

namespace {

/// A barrier at which threads wait for each other, with a time limit.
class Meeting {
 public:
  explicit Meeting(int expected) : expected_(expected) {}
  void join() {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    for (++arrived_; !complete() && std::chrono::steady_clock::now() < end;)
      std::this_thread::yield();
  }
  bool complete() const { return arrived_ == expected_; }

 private:
  int expected_;
  std::atomic<int> arrived_ = 0;
};

}  // namespace

TEST_CASE("workers do each task exactly once") {
  for (const int threads : {1, 2, 3, 5}) {
    Workers workers(threads);
    CHECK(workers.threads() == threads);
    for (const std::size_t count : {0u, 1u, 2u, 3u, 7u, 1000u}) {
      std::vector<int> done(count, 0);  // not atomic: each belongs to one task
      workers.each(count, [&](std::size_t k) { ++done[k]; });
      CAPTURE(threads);
      CAPTURE(count);
      CHECK(done == std::vector<int>(count, 1));
    }
  }
}

// Calls at all intervals: while the others are spinning, falling asleep (after 30 µs), and asleep.
TEST_CASE("results of tasks are visible after each of many calls") {
  for (const int threads : {2, 3}) {
    Workers workers(threads);
    std::vector<std::size_t> value(8, 0);
    for (std::size_t call = 1; call <= 4000; ++call) {
      workers.each(value.size(), [&](std::size_t k) { value[k] += k; });
      if (call % 50 == 0) std::this_thread::sleep_for(std::chrono::microseconds(call / 50));
      for (std::size_t k = 0; k < value.size(); ++k) REQUIRE(value[k] == call * k);
    }
  }
}

// The count of calls has 16 bits and wraps around.
TEST_CASE("workers survive an overflow of their call counter") {
  Workers workers(2);
  std::size_t sum[2] = {0, 0};
  constexpr std::size_t calls = 70000;
  for (std::size_t n = 0; n < calls; ++n) workers.each(2, [&](std::size_t k) { ++sum[k]; });
  CHECK(sum[0] == calls);
  CHECK(sum[1] == calls);
}

TEST_CASE("workers take part in the work, from spinning and from sleep") {
  for (const int threads : {2, 3}) {
    Workers workers(threads);
    for (const int gap : {0, 5, 0}) {  // [ms]
      std::this_thread::sleep_for(std::chrono::milliseconds(gap));
      Meeting meeting(threads);
      workers.each(static_cast<std::size_t>(threads), [&](std::size_t) { meeting.join(); });
      CHECK(meeting.complete());
    }
  }
}

TEST_CASE("a call ends after the last of its tasks") {
  Workers workers(2);
  const auto caller = std::this_thread::get_id();
  for (const int late : {1, 0}) {  // the other thread, so that the caller falls asleep; the caller
    Meeting meeting(2);
    std::atomic<int> done = 0;
    workers.each(2, [&](std::size_t) {
      meeting.join();
      if ((std::this_thread::get_id() != caller) == (late == 1))
        std::this_thread::sleep_for(std::chrono::milliseconds(3));
      ++done;
    });
    CHECK(meeting.complete());
    CHECK(done == 2);
  }
}

TEST_CASE(
    "if two tasks throw, the exception of the lower index is rethrown, whichever came first") {
  Workers workers(2);
  for (const std::size_t late : {0u, 1u}) {
    Meeting meeting(2);
    std::string what;
    try {
      workers.each(2, [&](std::size_t k) {
        meeting.join();
        if (k == late) std::this_thread::sleep_for(std::chrono::milliseconds(3));
        throw std::runtime_error(std::to_string(k));
      });
    } catch (const std::runtime_error& e) {
      what = e.what();
    }
    CHECK(what == "0");
  }
}

TEST_CASE("tasks after one that throws are not started") {
  Workers workers(2);
  Meeting meeting(2);
  std::atomic<int> started = 0;
  CHECK_THROWS_AS(workers.each(300,
                               [&](std::size_t k) {
                                 ++started;
                                 if (k % 150 == 0) meeting.join();  // the first task of each thread
                                 if (k == 0) throw std::runtime_error("0");
                                 std::this_thread::sleep_for(std::chrono::milliseconds(1));
                               }),
                  std::runtime_error);
  CHECK(started < 300);
}

TEST_CASE("a task before one that throws is started, although its thread is late") {
  Workers workers(2);
  Meeting meeting(2);
  std::atomic<bool> thrown = false;
  std::string what;
  try {
    workers.each(4, [&](std::size_t k) {  // the shares are 0 and 1, and 2 and 3
      if (k % 2 == 0) meeting.join();
      if (k == 0)
        while (!thrown) std::this_thread::yield();
      if (k == 2) thrown = true;
      if (k > 0) throw std::runtime_error(std::to_string(k));
    });
  } catch (const std::runtime_error& e) {
    what = e.what();
  }
  CHECK(what == "1");
}

TEST_CASE("two threads have the same shares of tasks in each call") {
  Workers workers(2);
  std::array<std::thread::id, 2> first;
  for (int call = 0; call < 20; ++call) {
    Meeting meeting(2);
    std::array<std::thread::id, 2> own;
    workers.each(2, [&](std::size_t k) {
      meeting.join();  // neither thread can run both tasks
      own[k] = std::this_thread::get_id();
    });
    if (call == 0) first = own;
    CHECK(own == first);
    CHECK(own[0] == std::this_thread::get_id());
  }
}

TEST_CASE("the exception of the lowest task is rethrown") {
  for (const int threads : {1, 2, 3}) {
    Workers workers(threads);
    for (int repeat = 0; repeat < 200; ++repeat) {
      std::string what;
      std::atomic<int> started = 0;
      try {
        workers.each(100, [&](std::size_t k) {
          ++started;
          if (k == 17 || k == 18 || k == 19) throw std::runtime_error(std::to_string(k));
        });
      } catch (const std::runtime_error& e) {
        what = e.what();
      }
      REQUIRE(what == "17");
      REQUIRE(started >= 18);
      int done = 0;  // the next call is a whole one
      std::vector<int> each(10, 0);
      workers.each(10, [&](std::size_t k) { each[k] = 1; });
      for (const int one : each) done += one;
      REQUIRE(done == 10);
    }
  }
}

TEST_CASE("a nested call is performed by the thread of its task") {
  Workers workers(3);
  std::vector<std::vector<int>> done(20, std::vector<int>(30, 0));
  std::atomic<int> strangers = 0;
  workers.each(done.size(), [&](std::size_t i) {
    const auto own = std::this_thread::get_id();
    workers.each(done[i].size(), [&](std::size_t k) {
      ++done[i][k];
      if (std::this_thread::get_id() != own) ++strangers;
    });
    Workers::serial().each(done[i].size(), [&](std::size_t k) { ++done[i][k]; });
  });
  for (const auto& row : done) CHECK(row == std::vector<int>(30, 2));
  CHECK(strangers == 0);
}

TEST_CASE("two threads may use the same workers") {
  Workers workers(2);
  std::atomic<int> sum = 0;
  const auto calls = [&] {
    for (int n = 0; n < 500; ++n) workers.each(10, [&](std::size_t) { ++sum; });
  };
  std::jthread other(calls);
  calls();
  other.join();
  CHECK(sum == 2 * 500 * 10);
}

TEST_CASE("serial workers are the calling thread") {
  const auto caller = std::this_thread::get_id();
  CHECK(Workers::serial().threads() == 1);
  Workers::serial().each(5, [&](std::size_t) { CHECK(std::this_thread::get_id() == caller); });
}
