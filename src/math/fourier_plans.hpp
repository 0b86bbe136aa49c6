// SPDX-License-Identifier: MIT
// FFTW makes plans on one thread at a time; any thread may carry them out.
#pragma once

#include <mutex>

namespace polhode {

/// To be held while a plan is made or destroyed.
inline std::mutex& fourier_planning() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace polhode
