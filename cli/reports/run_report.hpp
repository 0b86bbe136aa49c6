// SPDX-License-Identifier: MIT
// What a run reports at its end.
#pragma once

#include "polhode/run/simulation/simulation.hpp"

namespace polhode::cli {

/// Prints the results of a run as text or JSON, and on standard error whether it was interrupted.
/// @return  the exit code
int print_run(const RunResult& result, const Simulation& simulation, bool json);

/// Prints to standard error from where a run that ended with an error can be resumed, if it can.
void note_resumable(const Simulation& simulation);

/// What is probably wrong, each with its remedy; nothing without warnings.
void print_warnings(const std::vector<Warning>& warnings);

}  // namespace polhode::cli
