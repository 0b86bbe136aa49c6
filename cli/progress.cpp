// SPDX-License-Identifier: MIT
#include "progress.hpp"
#include "streams.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

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

Progress::Progress(std::string what)
    : what_(std::move(what)), terminal_(isatty(STDERR_FILENO) != 0), start_(Clock::now()) {}

Progress::~Progress() {
  if (terminal_) log("\r\033[K");
}

bool Progress::due(bool last) {
  if (!terminal_ || (since(last_) < 0.2 && !last)) return false;
  last_ = Clock::now();
  return true;
}

void Progress::show(const std::string& now) {
  if (!due(false)) return;
  log("\r\033[K{} {}  {}", what_, now, duration(since(start_)));
  std::fflush(stderr);
}

void Progress::show(double fraction, const std::string& now) {
  if (!due(fraction >= 1)) return;
  const double elapsed = since(start_);
  const std::string left =
      fraction > 0 ? duration(elapsed * (1 - fraction) / fraction) + " left" : "";
  log("\r\033[K{} {:5.1f} %  {}  {}  {}", what_, 100 * fraction, duration(elapsed), left, now);
  std::fflush(stderr);
}

}  // namespace polhode::cli
