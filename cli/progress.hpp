// SPDX-License-Identifier: MIT
// A progress line on the terminal: the fraction done and the expected end. Silent if standard error
// is not a terminal.
#pragma once

#include <chrono>
#include <string>

namespace polhode::cli {

class Progress {
 public:
  explicit Progress(std::string what);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// @param fraction  of the work done, 0 to 1
  void show(double fraction, const std::string& now = {});
  /// For a job of unknown length.
  void show(const std::string& now);

 private:
  bool due(bool last);

  std::string what_;
  bool terminal_;
  std::chrono::steady_clock::time_point start_, last_;
};

}  // namespace polhode::cli
