// SPDX-License-Identifier: MIT
#include "progress_line.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>

#include "streams.hpp"

namespace polhode::cli {
namespace {

std::string duration(double seconds) {
  const auto s = static_cast<long>(seconds + 0.5);
  return s < 3600 ? fmt::format("{}:{:02}", s / 60, s % 60)
                  : fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

/// The text of the progress line.
/// @param worked  fraction of the work done in the `elapsed` seconds since the start
std::string line_of(const Progress& now, double worked, double elapsed) {
  if (!now.done) return fmt::format("{} {}  {}", now.job, now.detail, duration(elapsed));
  std::string line = fmt::format("{} {:5.1f} %  {}", now.job, 100 * *now.done, duration(elapsed));
  if (worked > 0) line += fmt::format("  {} left", duration(elapsed * (1 - *now.done) / worked));
  return now.detail.empty() ? line : line + "  " + now.detail;
}

}  // namespace

ProgressLine::ProgressLine() : terminal_(isatty(STDERR_FILENO) != 0) {}

void ProgressLine::clear() {
  if (shown_) log("\r\033[K");
  shown_ = false;
}

void ProgressLine::begin(const Progress& now) {
  job_ = now.job;
  watch_ = Stopwatch();
  done_at_start_ = now.done.value_or(0);
  terminal_pace_ = {};
  log_pace_ = {};
}

bool ProgressLine::due(const Progress& now, double elapsed) {
  return terminal_ ? terminal_pace_.due(now.done, elapsed) : log_pace_.due(now.done, elapsed);
}

void ProgressLine::show(const Progress& now) {
  if (now.job != job_) begin(now);
  const double elapsed = watch_.seconds();
  if (!due(now, elapsed)) return;
  const std::string line = line_of(now, now.done.value_or(0) - done_at_start_, elapsed);
  if (terminal_)
    log("\r\033[K{}", line);
  else
    log("{}\n", line);
  std::fflush(stderr);
  shown_ = terminal_;
}

}  // namespace polhode::cli
