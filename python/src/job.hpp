// SPDX-License-Identifier: MIT
// A job of the library called from Python: without the interpreter's lock, with progress and
// messages for Python functions, ended by Ctrl-C.
#pragma once

#include <nanobind/nanobind.h>

#include <chrono>

#include "polhode/run/callbacks.hpp"

namespace polhode::python {

/// What Python is told during a job; each None or a function.
struct JobHooks {
  nanobind::object progress;  ///< called with (job, fraction done or None, detail)
  nanobind::object message;   ///< called with a line of text
};

/// Notes Ctrl-C while it exists, in the main thread of Python; elsewhere it does nothing. The
/// signal also reaches Python's own handler.
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
  explicit Job(JobHooks hooks) : hooks_(std::move(hooks)) {}

  /// Calls f(callbacks) without the interpreter's lock, and returns its result.
  /// @throws nanobind::python_error  with KeyboardInterrupt, if it was ended by Ctrl-C
  template <class F>
  auto run(const F& f) {
    auto result = [&] {
      const nanobind::gil_scoped_release released;
      return f(callbacks());
    }();
    raise_signals();
    return result;
  }

 private:
  Callbacks callbacks();
  void progress(const Progress& now);
  void raise_signals() const;

  JobHooks hooks_;
  InterruptWatch interrupt_;
  std::chrono::steady_clock::time_point shown_{};  // when progress was last reported
};

}  // namespace polhode::python
