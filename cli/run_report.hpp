// SPDX-License-Identifier: MIT
// What a run reports at its end.
#pragma once

#include "polhode/run/simulation/simulation.hpp"

namespace polhode::cli {

/// Prints the results of a run as text or JSON, and on standard error whether it was interrupted.
/// @return  the exit code
int print_run(const RunResult& result, const Simulation& simulation, bool json);

/// On standard error: where a run resumes that ended with an error, if it can be resumed.
void note_resumable(const Simulation& simulation);

}  // namespace polhode::cli
