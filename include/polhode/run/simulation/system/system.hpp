// SPDX-License-Identifier: MIT
// Builds the system that a run file describes, ready for simulation.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "polhode/forces/force_field.hpp"
#include "polhode/integrate/scheme.hpp"
#include "polhode/io/settings/config.hpp"
#include "polhode/math/shape.hpp"
#include "polhode/measure/energy.hpp"
#include "polhode/model/state.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

struct System {
  Topology topology;
  Bodies bodies;
  State state;
  ForceSettings forces;
  double temperature;             ///< target temperature [K]
  double fit_deviation = 0;       ///< deviation of initial configuration and rigid models [nm]
  double massless_deviation = 0;  ///< deviation of its massless sites, which are recomputed [nm]
  /// Momenta were drawn: the initial configuration has no velocities, or the run file requests new
  /// ones.
  bool new_velocities = true;
  double file_temperature = 0;  ///< T of the velocities of the initial configuration [K]
  /// Velocity of the centre of mass in an initial configuration with velocities [nm/ps], and
  /// its contribution to the temperature [K]; it is removed.
  double removed_velocity = 0, removed_temperature = 0;
  /// How the shape was determined, for each part of the topology from a topology file.
  std::vector<std::string> origins{};
  /// Shapes by molecule type that a topology file does not determine (RigidTopology::shapes).
  std::map<std::string, Shape> shapes{};
};

/// The molecules of a run file; a count that is to be taken from the initial configuration is 0.
/// @throws Error  if there is no such model
Topology build_topology(const SystemSettings& settings);

/// Molecules, initial configuration and momenta of a run file.
/// @throws Error  with its place if anything does not fit: counts, box, cutoff, overlapping
///                molecules
System build_system(const Config& config);

/// Energies of a state of the system, given the Load at its positions. External forces may move the
/// centre of mass: with them its energy is included, so that the total energy is conserved.
Energies energies_of(const System& system, const State& state, const Load& load,
                     Workers& workers = Workers::serial());

/// Draws new momenta at the system's temperature, with zero total momentum.
void draw_momenta(System& system, std::uint64_t seed);

/// Rescales the momenta of translations and of rotations separately to a temperature [K].
void rescale(State& state, const Topology& topology, const Bodies& bodies, double temperature);

}  // namespace polhode
