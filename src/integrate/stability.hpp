// SPDX-License-Identifier: MIT
// The longest stable step of a scheme for a harmonic oscillator.
#pragma once

#include "polhode/integrate/scheme.hpp"

namespace polhode {

/// The largest ω h at which a scheme is stable for an oscillator of frequency ω; the limit is 2 for
/// Verlet. Up to the stability limit, the trace of the one-step matrix is between −2 and 2
/// [allen2017, section 3.2]. Baths are ignored.
double stability_limit(const Scheme& scheme);

}  // namespace polhode
