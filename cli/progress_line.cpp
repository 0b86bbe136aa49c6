// SPDX-License-Identifier: MIT
#include "progress_line.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>

#include "streams.hpp"

namespace polhode::cli {
namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point t) {
  return std::chrono::duration<double>(Clock::now() - t).count();
}

std::string duration(double seconds) {
  const auto s = static_cast<long>(seconds + 0.5);
  return s < 3600 ? fmt::format("{}:{:02}", s / 60, s % 60)
                  : fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

}  // namespace

ProgressLine::ProgressLine() : terminal_(isatty(STDERR_FILENO) != 0) {}

void ProgressLine::clear() {
  if (shown_) log("\r\033[K");
  shown_ = false;
}

bool ProgressLine::due(const Progress& now) {
  if (!terminal_) return false;
  if (now.job != job_) {
    job_ = now.job;
    start_ = Clock::now();
    last_ = {};
  }
  if (since(last_) < 0.2 && now.done.value_or(0) < 1) return false;
  last_ = Clock::now();
  return true;
}

void ProgressLine::show(const Progress& now) {
  if (!due(now)) return;
  const double elapsed = since(start_);
  if (now.done) {
    const double done = *now.done;
    const std::string left = done > 0 ? duration(elapsed * (1 - done) / done) + " left" : "";
    log("\r\033[K{} {:5.1f} %  {}  {}  {}", now.job, 100 * done, duration(elapsed), left,
        now.detail);
  } else {
    log("\r\033[K{} {}  {}", now.job, now.detail, duration(elapsed));
  }
  std::fflush(stderr);
  shown_ = true;
}

}  // namespace polhode::cli
