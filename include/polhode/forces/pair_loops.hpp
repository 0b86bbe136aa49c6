// SPDX-License-Identifier: MIT
// The loops of a force evaluation, compiled once per instruction set.
#pragma once

#include "polhode/base/target.hpp"
#include "polhode/forces/laws.hpp"
#include "polhode/forces/neighbours.hpp"
#include "polhode/forces/pair_table.hpp"
#include "polhode/model/load.hpp"

namespace polhode {

/// Bodies first ≤ i < end of one molecule type with all partners of another.
struct PairJob {
  const PairTable& table;
  const PairLaws& laws;
  const NeighbourList& list;
  const Vec3Column* arms;            ///< per site number
  const Vec3<double>* image_shifts;  ///< [nm]
  std::size_t first, end, partner_part;
  double
      range2;  ///< the square of the longest distance of centres at which the pair interacts [nm²]
};

/// Scratch space for the partners of one body.
struct PartnerBuffer {
  Column<std::int64_t> body;
  Vec3Column R;  ///< from the body to each partner [nm]

  void reserve(std::size_t partners) {
    if (body.size() > partners) return;
    body = Column<std::int64_t>(partners + pack_bytes);
    R = Vec3Column(partners + pack_bytes);
  }
};

POLHODE_DECLARE_LOOPS(
    /// Sites from the body frame to the lab, for bodies first ≤ i < end: arm = Sᵀ r.
    void site_arms(const QuaternionColumn& attitude, const std::vector<Vec3<double>>& sites,
                   std::size_t first, std::size_t end, Vec3Column* arms);
    /// Adds the forces, torques and energies of a job's pairs to the load.
    void pair_forces(const PairJob& job, PartnerBuffer& buffer, Load& load);)

}  // namespace polhode
