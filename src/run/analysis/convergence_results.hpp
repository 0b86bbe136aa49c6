// SPDX-License-Identifier: MIT
// Results that are reported only if the run is long enough for them.
#pragma once

#include <string>

#include "measure/convergence.hpp"
#include "polhode/run/quantities.hpp"

namespace polhode {

/// The relaxation time of a number in a text, and whether it is that of the window of lags.
struct RelaxationName {
  const char* text;
  bool window = false;
};
inline constexpr RelaxationName max_lag{"maximum lag", true}, decay_time{"decay to 1/e³ within"},
    dipole_relaxation{"relaxation"};

/// Why a number is not a result, and what to do: "not converged: length 20 ps, relaxation 5.6 ps;
/// a run of at least 170 ps is needed".
std::string not_converged(const Convergence& c, const RelaxationName& relaxation);

/// An estimate that has a value only if it is converged; if not, the list gives the reason.
Quantities converging(const SeriesEstimate& estimate, const Convergence& c,
                      const RelaxationName& relaxation);

}  // namespace polhode
