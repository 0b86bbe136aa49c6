// SPDX-License-Identifier: MIT
#include "console.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <initializer_list>
#include <memory>
#include <string>

#include "base/stopwatch.hpp"
#include "run/progress_pace.hpp"
#include "streams.hpp"

namespace polhode::cli {
namespace {

// All threads of a study read this flag, and the signal handler may run in any of these threads.
std::atomic<bool> caught = false;
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void remember(int) { caught = true; }

void take(int signal_number, int flags) {
  struct sigaction action {};
  action.sa_handler = remember;
  action.sa_flags = flags;
  sigaction(signal_number, &action, nullptr);
}

/// Installs handlers, so that Ctrl-C, SIGTERM, SIGHUP and SIGXCPU only set a flag that loops poll.
/// A second Ctrl-C or SIGTERM ends the program immediately.
void catch_interrupts() {
  // A second signal has its default effect and ends the program at once.
  for (const int signal_number : {SIGINT, SIGTERM})
    take(signal_number, static_cast<int>(SA_RESETHAND));
  // The system may send SIGXCPU every second beyond the CPU time limit, and SIGHUP more than once
  // when a terminal closes.
  take(SIGXCPU, 0);
  struct sigaction hangup {};
  sigaction(SIGHUP, nullptr, &hangup);
  if (hangup.sa_handler != SIG_IGN) take(SIGHUP, 0);  // nohup ignores this signal
}

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

/// The progress of a job on standard error, with the expected end time. On a terminal, a single
/// progress line is updated; in a log, a new line is added from time to time.
class ProgressLine {
 public:
  ProgressLine() = default;
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Shows the progress of a job: on a terminal at most five times a second, and in a log at the
  /// intervals that ProgressPace sets.
  void show(const Progress& now) {
    if (now.job != job_.name) job_ = {.name = now.job, .done_at_start = now.done.value_or(0)};
    const double elapsed = job_.watch.seconds();
    if (!due(now, elapsed)) return;
    const std::string line = line_of(now, now.done.value_or(0) - job_.done_at_start, elapsed);
    if (terminal_)
      log("\r\033[K{}", line);
    else
      log("{}\n", line);
    std::fflush(stderr);
    shown_ = terminal_;
  }

  /// Erases the line on a terminal until progress is shown again.
  void clear() {
    if (shown_) log("\r\033[K");
    shown_ = false;
  }

 private:
  struct Job {
    std::string name{};
    double done_at_start = 0;  // fraction done when the job was resumed
    Stopwatch watch{};         // time since the start of the job [s]
    TerminalPace terminal_pace{};
    ProgressPace log_pace{};
  };

  bool due(const Progress& now, double elapsed) {
    return terminal_ ? job_.terminal_pace.due(now.done, elapsed)
                     : job_.log_pace.due(now.done, elapsed);
  }

  bool terminal_ = isatty(STDERR_FILENO) != 0, shown_ = false;
  Job job_;
};

}  // namespace

Callbacks console() {
  catch_interrupts();
  const auto line = std::make_shared<ProgressLine>();
  return {.progress = [line](const Progress& now) { line->show(now); },
          .stop = [] { return caught.load(); },
          .message =
              [line](const std::string& text) {
                line->clear();
                log("{}\n", text);
              }};
}

}  // namespace polhode::cli
