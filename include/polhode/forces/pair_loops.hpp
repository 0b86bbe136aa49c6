// SPDX-License-Identifier: MIT
// The loops of a force evaluation, compiled once per instruction set.
#pragma once

#include "polhode/base/target.hpp"
#include "polhode/forces/laws.hpp"
#include "polhode/forces/neighbours.hpp"
#include "polhode/forces/pair_table.hpp"
#include "polhode/model/load.hpp"

namespace polhode {

/// The arms of all bodies, lab frame, one record a body: a partner's arms lie side by side.
struct ArmRecords {
  std::size_t stride = 0;  ///< doubles a body
  Column<double> values;   ///< x, y, z of arm 0, of arm 1, ... [nm]

  ArmRecords() = default;
  ArmRecords(std::size_t bodies, std::size_t most)
      : stride(Column<double>::padded(3 * most)),
        values(bodies * stride + pack_bytes) {}  // packs read beyond a record
  const double* of(std::size_t body) const { return &values[body * stride]; }
  double* of(std::size_t body) { return &values[body * stride]; }
};

/// Bodies first ≤ i < end of one molecule type with all partners of another.
struct PairJob {
  const PairTable& table;
  const PairLaws& laws;
  const NeighbourList& list;
  const ArmRecords& arms;
  const Vec3<double>* image_shifts;  ///< [nm]
  std::size_t first, end, partner_part;
  double
      range2;  ///< the square of the longest distance of centres at which the pair interacts [nm²]
};

/// Scratch space for the partners of one body that are in range.
struct PartnerBuffer {
  std::vector<std::uint32_t> body;
  Vec3Column R;  ///< centres relative to the body's [nm]

  void reserve(std::size_t partners) {
    if (body.size() >= partners + pack_bytes) return;
    body.assign(partners + partners / 4 + pack_bytes, 0);
    R = Vec3Column(body.size());
  }
};

POLHODE_DECLARE_LOOPS(
    /// Sites from the body frame to the lab, for bodies first ≤ i < end: arm = Sᵀ r.
    void site_arms(const QuaternionColumn& attitude, const std::vector<Vec3<double>>& sites,
                   std::size_t first, std::size_t end, ArmRecords& arms);
    /// Adds the forces, torques and energies of a job's pairs to the load.
    void pair_forces(const PairJob& job, PartnerBuffer& buffer, Load& load);)

}  // namespace polhode
