// SPDX-License-Identifier: MIT
// Results that are reported only if the run is long enough for them.
#pragma once

#include <string>

#include "measure/convergence.hpp"
#include "polhode/run/quantities.hpp"

namespace polhode {

/// The name of a relaxation time in texts, and whether this time is the largest lag of the window.
struct RelaxationName {
  const char* text;
  bool window = false;
};
inline constexpr RelaxationName max_lag{"maximum lag", true}, decay_time{"decay to 1/e³ within"},
    dipole_relaxation{"relaxation"};

/// The reason why a number is not converged, with advice, such as "not converged: length 20 ps,
/// relaxation 5.6 ps; a run of at least 170 ps is needed".
std::string not_converged(const Convergence& c, const RelaxationName& relaxation);

/// An estimate as a list. If the number is converged, the list has its value; otherwise the list
/// has the reason why the number is not converged.
Quantities converging(const SeriesEstimate& estimate, const Convergence& c,
                      const RelaxationName& relaxation);

}  // namespace polhode
