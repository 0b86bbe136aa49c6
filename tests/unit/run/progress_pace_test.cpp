// SPDX-License-Identifier: MIT
#include "run/progress_pace.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <cstdlib>

#include "polhode/base/workers.hpp"

namespace polhode {

TEST_CASE("a log has a line at each tenth of a job") {
  ProgressPace pace;
  int lines = 0;
  for (int percent = 0; percent <= 100; ++percent)
    if (pace.due(percent / 100.0, 5.0 * percent)) {
      CHECK(percent % 10 == 0);
      ++lines;
    }
  CHECK(lines == 10);
}

TEST_CASE("a slow job has a line each minute") {
  for (const bool known : {true, false}) {
    ProgressPace pace;
    int lines = 0;
    for (int second = 0; second <= 600; ++second)  // 10 minutes, in which 5 % of the work is done
      lines += pace.due(known ? std::optional(second / 12000.0) : std::nullopt, second) ? 1 : 0;
    CHECK(lines == 10);
  }
}

// A job whose work turns out to be more than expected reports after every step that all is done.
TEST_CASE("a line on a terminal is written five times a second, and when the job is done") {
  TerminalPace pace;
  int lines = 0;
  for (int step = 0; step < 1000; ++step) lines += pace.due(0.5, 0.001 * step) ? 1 : 0;
  CHECK(std::abs(lines - 5) <= 1);  // rounding of the times
  CHECK(pace.due(1, 1.0));
  lines = 0;
  for (int step = 1; step <= 1000; ++step) lines += pace.due(1, 1 + 0.001 * step) ? 1 : 0;
  CHECK(std::abs(lines - 5) <= 1);
}

TEST_CASE("threads that report after every step share one pace") {
  SharedPace pace;
  constexpr double now = 3600;
  std::atomic<int> due = 0;
  Workers(4).each(1000, [&](std::size_t) { due += pace.due(now) ? 1 : 0; });
  CHECK(due == 1);
  CHECK(!pace.due(now + SharedPace::interval / 2));
  CHECK(pace.due(now + SharedPace::interval));
}

TEST_CASE("a job of less than a second has no line in a log") {
  ProgressPace pace;
  for (int percent = 0; percent <= 100; ++percent)
    CHECK(!pace.due(percent / 100.0, 0.009 * percent));
}

}  // namespace polhode
