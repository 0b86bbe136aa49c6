// SPDX-License-Identifier: MIT
// Log lines about a system: molecules that come from a topology file, and unusual force settings.
#pragma once

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "polhode/base/printable.hpp"
#include "polhode/io/file_lock.hpp"
#include "polhode/model/degrees_of_freedom.hpp"
#include "polhode/run/simulation/system.hpp"
#include "streams.hpp"

namespace polhode::cli {

/// On standard error: the molecules of a topology file, and how their rigid shapes were determined;
/// the distance of atoms in the initial configuration from the rigid bodies, if it exceeds
/// rounding, and of massless sites, if it exceeds what that of the atoms explains.
inline void note_molecules(const System& system) {
  for (std::size_t k = 0; k < system.origins.size(); ++k) {
    const auto& [molecule, count] = system.topology.parts[k];
    log("{}: {} of {} sites, {}\n", molecule.name, count, molecule.sites.size(),
        printable(system.origins[k]));
  }
  if (system.fit_deviation > 1e-4)
    log("note: atoms of the initial configuration deviate by up to {:.4f} nm from the rigid "
        "models\n",
        system.fit_deviation);
  if (system.massless_deviation > std::max(1e-3, 2 * system.fit_deviation))
    log("note: massless sites of the initial configuration deviate by up to {:.4f} nm from the "
        "models and are placed according to them\n",
        system.massless_deviation);
  if (system.removed_temperature > 1e-4)
    log("note: the centre of mass of the initial configuration moves at {:.4g} nm/ps, which "
        "amounts to {:.4g} K; the total momentum is removed\n",
        system.removed_velocity, system.removed_temperature);
  if (degrees_of_freedom(system.topology).all() == 0)
    log("note: a single atom without total momentum has no degrees of freedom, so it has no "
        "temperature\n");
}

/// Warns on standard error if the file system has no locks.
inline void note_lock(const FileLock& lock) {
  if (!lock.is_held())
    log("note: the file system does not support locks; do not start a second process with the same "
        "output\n");
}

/// On standard error: the mixing rule and explicit pairs, unless all pairs follow the default rule;
/// grid, order and split of a mesh; a net charge.
inline void note_forces(const System& system) {
  const ForceSettings& forces = system.forces;
  if (const std::string mixing = description(forces.mixing); !mixing.empty())
    log("Lennard-Jones: {}\n", mixing);
  if (forces.mesh)
    log("PME: grid {} x {} x {}, order {}, split exponent {}, for a relative force error of "
        "{:g}\n",
        forces.mesh->points[0], forces.mesh->points[1], forces.mesh->points[2], forces.mesh->order,
        forces.mesh->exponent, forces.pme_accuracy);
  double net = 0;
  for (const auto& part : system.topology.parts)
    net += static_cast<double>(part.count) * part.molecule.charge();
  if (std::abs(net) > 1e-6)
    log("net charge {:+.6g} e{}\n", net,
        forces.mesh ? ", neutralised by a uniform background" : "");
}

}  // namespace polhode::cli
