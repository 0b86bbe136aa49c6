// SPDX-License-Identifier: MIT
// FFTW's planner is not thread-safe; plans may be executed from any thread.
#pragma once

#include <mutex>

namespace polhode {

/// To be held while a plan is created or destroyed.
inline std::mutex& fourier_planning() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace polhode
