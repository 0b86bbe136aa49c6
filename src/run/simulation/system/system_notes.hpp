// SPDX-License-Identifier: MIT
// Notes for users on a system before its simulation, as lines of text.
#pragma once

#include <string_view>

#include "polhode/run/callbacks.hpp"
#include "polhode/run/simulation/system/system.hpp"
#include "polhode/run/simulation/trajectory/trajectory_settings.hpp"

namespace polhode {

/// Gives notes on the molecules of a topology file and on how their rigid shapes were determined. A
/// note also reports how far atoms of the initial configuration deviate from the rigid bodies, if
/// this deviation exceeds round-off. The deviation of massless sites is also given if it exceeds
/// the deviation of the atoms.
void note_molecules(const System& system, const Callbacks& callbacks);

/// Gives a note on the use of velocities in the initial configuration. The note is given only if
/// the initial configuration has velocities, and if the run file has a temperature or a seed.
void note_velocities(const System& system, const Config& config, const Callbacks& callbacks);

/// Gives notes on thermostat, barostat and hybrid Monte Carlo, unless the run is at constant
/// energy. A note also reports a length that is rounded up to whole trajectories of hybrid Monte
/// Carlo.
void note_ensemble(const TrajectorySettings& settings, const Callbacks& callbacks);

/// Gives a note that runs are at constant energy, if the run file has a thermostat, a barostat or
/// hybrid Monte Carlo.
/// @param what  job that performs the runs, such as "the study"
void note_constant_energy(const Config& config, std::string_view what, const Callbacks& callbacks);

/// Checks that states are not read through a postprocessor, for jobs that cannot do this.
/// @param what  job, such as "the adviser"
/// @throws Error  if output.processed is true
void check_not_processed(const Config& config, std::string_view what);

/// Gives notes on the forces: the mixing rule and explicit pairs, unless all pairs follow the
/// default rule; grid, order and split of a mesh; a net charge.
void note_forces(const System& system, const Callbacks& callbacks);

}  // namespace polhode
