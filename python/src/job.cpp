// SPDX-License-Identifier: MIT
#include "job.hpp"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <atomic>
#include <csignal>

namespace polhode::python {
namespace {

namespace nb = nanobind;
using namespace std::chrono_literals;

std::atomic<bool> signalled = false;
static_assert(std::atomic<bool>::is_always_lock_free);
bool watched = false;  // whether an outer job watches for Ctrl-C; protected by the interpreter's
                       // lock
void (*python_handler)(int) = nullptr;

extern "C" void remember(int signal_number) {
  signalled = true;
  python_handler(signal_number);
}

bool in_main_thread() {
  const nb::module_ threading = nb::module_::import_("threading");
  return threading.attr("current_thread")().is(threading.attr("main_thread")());
}

}  // namespace

InterruptWatch::InterruptWatch() : main_thread_(in_main_thread()) {
  if (!main_thread_ || watched) return;
  signalled = false;  // an earlier signal must not stop this job, even if no handler is installed
  struct sigaction now {};
  sigaction(SIGINT, nullptr, &now);
  const bool of_python = (now.sa_flags & SA_SIGINFO) == 0 && now.sa_handler != SIG_DFL &&
                         now.sa_handler != SIG_IGN && now.sa_handler != remember;
  if (!of_python) return;
  python_handler = now.sa_handler;
  now.sa_handler = remember;
  installed_ = watched = sigaction(SIGINT, &now, nullptr) == 0;
}

InterruptWatch::~InterruptWatch() {
  if (!installed_) return;
  struct sigaction now {};
  sigaction(SIGINT, nullptr, &now);
  now.sa_handler = python_handler;
  sigaction(SIGINT, &now, nullptr);
  watched = false;
}

bool InterruptWatch::caught() const { return main_thread_ && signalled; }

Callbacks Job::callbacks() {
  Callbacks callbacks{.stop = [this] { return interrupt_.caught(); }};
  if (!progress_.is_none())
    callbacks.progress = [this](const Progress& now) {
      const auto time = std::chrono::steady_clock::now();
      if (time - shown_ < 100ms) return;
      shown_ = time;
      const nb::gil_scoped_acquire acquired;
      progress_(now.job, now.done, now.detail);
    };
  if (!message_.is_none())
    callbacks.message = [this](const std::string& text) {
      const nb::gil_scoped_acquire acquired;
      message_(text);
    };
  return callbacks;
}

}  // namespace polhode::python
