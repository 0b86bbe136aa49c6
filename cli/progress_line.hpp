// SPDX-License-Identifier: MIT
// A progress line on the terminal: the fraction done and the expected end. Silent if standard error
// is not a terminal.
#pragma once

#include <chrono>
#include <string>

#include "polhode/run/callbacks.hpp"

namespace polhode::cli {

class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Shows a job's progress, at most five times a second.
  void show(const Progress& now);
  /// Erases the line, until progress is shown again.
  void clear();

 private:
  bool due(const Progress& now);

  bool terminal_, shown_ = false;
  std::string job_;
  std::chrono::steady_clock::time_point start_, last_;  // of the job, and when it was shown last
};

}  // namespace polhode::cli
