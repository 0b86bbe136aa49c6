// SPDX-License-Identifier: MIT
// A job of the library called from Python. The job runs without the interpreter's lock, reports
// progress and messages to Python functions, and ends on Ctrl-C.
#pragma once

#include <nanobind/nanobind.h>

#include <chrono>

#include "polhode/run/callbacks.hpp"

namespace polhode::python {

/// Detects Ctrl-C while this object exists, in the main thread of Python. In other threads, this
/// object does nothing. The signal also reaches Python's handler.
class InterruptWatch {
 public:
  InterruptWatch();
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;
  bool caught() const;

 private:
  bool main_thread_, installed_ = false;
};

class Job {
 public:
  /// @param progress  None, or a function called with (job, fraction done or None, detail)
  /// @param message   None, or a function called with a line of text
  Job(nanobind::object progress, nanobind::object message)
      : progress_(std::move(progress)), message_(std::move(message)) {}

  /// Calls f(callbacks) without the interpreter's lock, and returns its result.
  /// @throws nanobind::python_error  with KeyboardInterrupt, if Ctrl-C ended the call
  template <class F>
  auto run(const F& f) {
    auto result = [&] {
      const nanobind::gil_scoped_release released;
      return f(callbacks());
    }();
    if (PyErr_CheckSignals() != 0) throw nanobind::python_error();
    return result;
  }

 private:
  Callbacks callbacks();

  nanobind::object progress_, message_;
  InterruptWatch interrupt_;
  std::chrono::steady_clock::time_point shown_{};  // time of the last progress report
};

}  // namespace polhode::python
