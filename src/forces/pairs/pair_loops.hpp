// SPDX-License-Identifier: MIT
// The loops of a force evaluation, compiled once per instruction set.
#pragma once

#include "base/instruction_set.hpp"
#include "forces/pairs/molecule_pair.hpp"
#include "forces/pairs/neighbours.hpp"
#include "forces/pairs/pair_table.hpp"
#include "polhode/base/column.hpp"
#include "polhode/model/load.hpp"

namespace polhode {

/// Positions of bodies and sites, with one record per slot. A record has three numbers for the
/// centre in the box, followed by x, y, z of each site relative to the centre, in the lab frame
/// [nm]. In double precision, centres are stored in nm. In single precision, centres are in fixed
/// point with 2³⁰ units per box edge, stored as the bits of a float. Differences of centres are
/// therefore exact before they are rounded.
template <class T>
struct SiteRecords {
  std::size_t stride = 0;  ///< stride of records in numbers; records are aligned for packs
  Column<T> values;

  SiteRecords() = default;
  SiteRecords(std::size_t slots, std::size_t max_sites_of_any)
      : stride(Column<T>::padded(3 + 3 * max_sites_of_any)), values(slots * stride) {}
  T* of(std::size_t slot) { return &values[slot * stride]; }
  const T* of(std::size_t slot) const { return &values[slot * stride]; }
};

/// Sums of forces [kJ/mol/nm] and torques [kJ/mol] from one chunk of the list, for the slots in the
/// windows of the chunk. The sums over pairs have the precision of the pair loops. A sum over one
/// chunk has only a few hundred terms, so the round-off errors of its terms exceed the round-off
/// error of the summation. Sums over chunks are in double precision.
template <class T>
struct ChunkSums {
  static constexpr std::size_t stride = 8;  ///< numbers per slot: force, torque, and two zeros
  Column<T> values;
  std::vector<std::size_t> first;  ///< index of the first record of each topology part
  double van_der_waals = 0, coulomb = 0;
  Mat3<double> virial{};
};

/// A job of the pair loops: the pairs in one chunk of the list whose partners have one molecule
/// type.
template <class T>
struct PairJob {
  const PairTable& table;
  const PairLaws<T>& laws;
  CutoffTreatment treatment;
  bool energies;  ///< whether energies and the virial are computed
  const NeighbourList& list;
  const ListChunk& chunk;
  std::size_t partner_part;
  const SiteRecords<T>& records;
  ChunkSums<T>& sums;
  /// For derivatives only: displacements of centres, and of sites relative to the centres, with the
  /// layout of the records.
  const SiteRecords<T>* displacements = nullptr;
};

/// A job that places the sites of bodies of one molecule type.
template <class T>
struct PlaceJob {
  const State& state;
  const Slots& slots;
  const std::vector<Vec3<double>>& sites;  ///< site positions in the order of InteractionSites,
                                           ///< body frame [nm]
  std::size_t first, end;                  ///< range of slots, multiples of slot_block
  SiteRecords<T>& records;
};

/// A job that computes the site displacements of bodies of one molecule type.
template <class T>
struct DisplaceJob {
  const State& state;
  const Slots& slots;
  const std::vector<Vec3<double>>& sites;  ///< site positions as in PlaceJob
  std::size_t first, end;
  const Vec3Column &dq, &dtheta;  ///< displacements of centres [nm], lab frame; rotations [rad],
                                  ///< body frame
  SiteRecords<T>& displacements;
};

POLHODE_DECLARE_LOOPS(
    /// Fills the records of the slots of a job. Returns the square of the largest displacement
    /// since the list was built [nm²].
    double place_sites(const PlaceJob<double>& job); double place_sites(const PlaceJob<float>& job);
    /// Fills the displacement records for the slots of a job.
    void displace_sites(const DisplaceJob<double>& job);
    void displace_sites(const DisplaceJob<float>& job);
    /// Adds the forces, torques and, if requested, energies and virial of a job's pairs to the sums
    /// of the job.
    void pair_forces(const PairJob<double>& job); void pair_forces(const PairJob<float>& job);
    /// Adds the derivatives of forces and torques to the sums of a job, for the pairs and
    /// displacements of the job.
    void pair_derivative(const PairJob<double>& job);
    void pair_derivative(const PairJob<float>& job);
    /// The number of pairs in a pack.
    std::size_t pair_lanes(const PairJob<double>*); std::size_t pair_lanes(const PairJob<float>*);)

}  // namespace polhode
