// SPDX-License-Identifier: MIT
// Checks of the requirements for a step search: forces in the system, and a minimum length of runs.
#pragma once

#include <string>
#include <string_view>

namespace polhode {

/// Checks that the system has forces.
/// @param frequency  frequency of the fastest motions [1/ps], from einstein_frequency()
/// @param source     file of the initial configuration's run, for error messages
/// @throws Error  if the forces are only round-off
void check_forces(double frequency, const std::string& source);

/// Checks the length of the test runs.
/// @param length  length of the runs [ps]
/// @param first   first step to be tried [ps]
/// @throws Error  if a run has less than ten steps
void check_length(double length, double first, std::string_view scheme);

}  // namespace polhode
