// SPDX-License-Identifier: MIT
// The splitting schemes as lists of quantities.
#pragma once

#include <vector>

#include "polhode/integrate/scheme.hpp"
#include "polhode/run/quantities.hpp"

namespace polhode {

/// Stages, order, cost and source of a scheme.
Quantities quantities(const Scheme& scheme);
/// Stages, order, cost and source of all built-in schemes.
std::vector<Quantities> all_schemes();

}  // namespace polhode
