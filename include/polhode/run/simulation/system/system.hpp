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
  double temperature;        ///< target temperature [K]
  double fit_deviation = 0;  ///< deviation of the initial configuration from the rigid models
                             ///< [nm]
  double massless_deviation =
      0;  ///< deviation of massless sites, whose positions are recomputed [nm]
  /// Whether momenta were drawn. New momenta are drawn if the initial configuration has no
  /// velocities, or if the run file requests new velocities.
  bool new_velocities = true;
  double file_temperature = 0;  ///< temperature of the velocities in the initial configuration [K]
  /// Centre-of-mass velocity that was removed from an initial configuration [nm/ps], and its
  /// contribution to the temperature [K].
  double removed_velocity = 0, removed_temperature = 0;
  /// How the shape of each part of a topology file was determined.
  std::vector<std::string> origins{};
  /// The shapes of those molecule types whose shape the topology file does not determine
  /// (RigidTopology::shapes).
  std::map<std::string, Shape> shapes{};
};

/// The molecules of a run file. A molecule count that the initial configuration determines is set
/// to 0.
/// @throws Error  if a model does not exist
Topology build_topology(const SystemSettings& settings);

/// Builds the system of a run file: molecules, initial configuration and momenta.
/// @throws Error  with its place, if molecule counts, box and cutoff contradict each other, or
///   molecules overlap
System build_system(const Config& config);

/// The energies of a state of the system, given the Load at its positions. External forces may move
/// the centre of mass. With external forces, the kinetic energy of the centre of mass is included,
/// so that the total energy is conserved.
Energies energies_of(const System& system, const State& state, const Load& load,
                     Workers& workers = Workers::serial());

/// Draws new momenta at the system's temperature, with zero total momentum.
void draw_momenta(System& system, std::uint64_t seed);

/// Rescales translational and rotational momenta separately to a temperature [K].
void rescale(State& state, const Topology& topology, const Bodies& bodies, double temperature);

}  // namespace polhode
