// SPDX-License-Identifier: MIT
// What a user should know of a system before it is simulated, in lines of text.
#pragma once

#include <string_view>

#include "polhode/run/callbacks.hpp"
#include "polhode/run/simulation/system/system.hpp"
#include "polhode/run/simulation/trajectory/trajectory_settings.hpp"

namespace polhode {

/// Notes on the molecules of a topology file and how their rigid shapes were determined; the
/// distances of atoms in the initial configuration from those of the rigid bodies, if they exceed
/// rounding, and those of massless sites, if they exceed the distances of the atoms.
void note_molecules(const System& system, const Callbacks& callbacks);

/// Note on the use of the velocities of the initial configuration, if it has any and the run file
/// gives a temperature or a seed.
void note_velocities(const System& system, const Config& config, const Callbacks& callbacks);

/// Notes on thermostat, barostat and hybrid Monte Carlo, unless the run is at constant energy; and
/// on a length that is rounded up to whole trajectories of hybrid Monte Carlo.
void note_ensemble(const TrajectorySettings& settings, const Callbacks& callbacks);

/// Note that these runs are at constant energy, if the run file has thermostat, barostat or hybrid
/// Monte Carlo.
/// @param what  "the study"
void note_constant_energy(const Config& config, std::string_view what, const Callbacks& callbacks);

/// Notes on the mixing rule and explicit pairs, unless all pairs follow the default rule; grid,
/// order and split of a mesh; a net charge.
void note_forces(const System& system, const Callbacks& callbacks);

}  // namespace polhode
