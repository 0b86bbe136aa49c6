// SPDX-License-Identifier: MIT
// The heat flux and the virials of molecules, of the interactions within the cutoff.
#pragma once

#include <vector>

#include "base/instruction_set.hpp"
#include "forces/laws/laws.hpp"
#include "forces/pairs/cutoff_treatment.hpp"
#include "forces/pairs/pair_table.hpp"
#include "polhode/base/column.hpp"
#include "polhode/base/vec3.hpp"

namespace polhode {

/// The motion of the bodies of a fluid of one kind of molecule.
struct Motion {
  Vec3Column q, v, omega;        ///< centres [nm], velocities [nm/ps], angular velocities [1/ps]
  std::vector<Vec3Column> arms;  ///< for each interaction site, its position relative to the centre
                                 ///< of its body [nm]
};

struct PairHeatFluxJob {
  const PairTable& table;
  const PairLaws<double>& laws;
  CutoffTreatment treatment;
  const Motion& motion;
  Vec3<double> edge;  ///< box edges [nm]
  double range;       ///< distance of centres beyond which bodies do not interact [nm]
  double share;       ///< part of the energy of a pair that belongs to its first body
};

POLHODE_DECLARE_LOOPS(
    /// Sums u (s v_i + (1 − s) v_j) + R (s P_j − (1 − s) P_i) over all pairs i < j, including
    /// periodic images. R is the vector from i to j, u the energy of the pair, s the share, and P
    /// the power of the pair's force and torque on each body [kJ/mol nm/ps].
    Vec3<double> pair_heat_flux(const PairHeatFluxJob& job);
    /// Adds half of R F of each pair to the virials of both bodies, for each axis. F is the force
    /// on the second body [kJ/mol].
    void pair_virials(const PairHeatFluxJob& job, Vec3Column& virials);)

}  // namespace polhode
