// SPDX-License-Identifier: MIT
// The splitting schemes as JSON.
#pragma once

#include <string>

#include "polhode/integrate/scheme.hpp"

namespace polhode {

/// Stages, order, cost and source of a scheme.
std::string scheme_json(const Scheme& scheme);
/// The same of all schemes of the table, as an array.
std::string schemes_json();

}  // namespace polhode
