// SPDX-License-Identifier: MIT
// The progress of a job on standard error, with its expected end: one line that changes on a
// terminal, a line now and then in a log.
#pragma once

#include <string>

#include "base/stopwatch.hpp"
#include "polhode/run/callbacks.hpp"
#include "run/progress_pace.hpp"

namespace polhode::cli {

class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Shows a job's progress: on a terminal at most five times a second, in a log at the pace of
  /// ProgressPace.
  void show(const Progress& now);
  /// Erases the line of a terminal, until progress is shown again.
  void clear();

 private:
  void begin(const Progress& now);
  bool due(const Progress& now, double elapsed);

  bool terminal_, shown_ = false;
  std::string job_;
  Stopwatch watch_;           // of the job
  double done_at_start_ = 0;  // of a job that was resumed
  TerminalPace terminal_pace_;
  ProgressPace log_pace_;
};

}  // namespace polhode::cli
