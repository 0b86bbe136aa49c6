// SPDX-License-Identifier: MIT
// One line on the terminal that tells how far a long job is and when it will end. Silent where
// standard error is no terminal.
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

  /// @param fraction  of the work that is done, 0 to 1
  void show(double fraction, const std::string& now = {});
  /// Of a job whose end is not known.
  void show(const std::string& now);

 private:
  bool due(bool last);

  std::string what_;
  bool terminal_;
  std::chrono::steady_clock::time_point start_, last_;
};

}  // namespace polhode::cli
