// SPDX-License-Identifier: MIT
// Energies of an initial configuration as text, forces and torques as CSV.
#pragma once

#include <string>

#include "polhode/run/simulation/system/single_point.hpp"

namespace polhode::cli {

/// Energies with ten digits, and the pressure tensor.
std::string text_of(const SinglePoint& point);

/// One line per body on standard output, all numbers with 17 digits.
void print_loads(const SinglePoint& point);

}  // namespace polhode::cli
