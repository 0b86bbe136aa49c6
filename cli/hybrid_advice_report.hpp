// SPDX-License-Identifier: MIT
// Advice for hybrid Monte Carlo as text.
#pragma once

#include "polhode/run/canonical/hybrid_adviser.hpp"

namespace polhode::cli {

void print_hybrid_advice(const HybridAdvice& advice);

}  // namespace polhode::cli
