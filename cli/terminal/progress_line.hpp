// SPDX-License-Identifier: MIT
// The progress of a job on standard error, with the expected end time. On a terminal, a single
// progress line is updated; in a log, a new line is added from time to time.
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

  /// Shows the progress of a job: on a terminal at most five times a second, and in a log at the
  /// intervals that ProgressPace sets.
  void show(const Progress& now);
  /// Erases the line on a terminal until progress is shown again.
  void clear();

 private:
  void begin(const Progress& now);
  bool due(const Progress& now, double elapsed);

  bool terminal_, shown_ = false;
  std::string job_;
  Stopwatch watch_;           // time since the start of the job [s]
  double done_at_start_ = 0;  // fraction done when the job was resumed
  TerminalPace terminal_pace_;
  ProgressPace log_pace_;
};

}  // namespace polhode::cli
