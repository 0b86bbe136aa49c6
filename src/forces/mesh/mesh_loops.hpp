// SPDX-License-Identifier: MIT
// The loops of the particle mesh, compiled once per instruction set.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/instruction_set.hpp"
#include "forces/mesh/mesh_grid.hpp"
#include "forces/pairs/pair_loops.hpp"
#include "polhode/base/column.hpp"

namespace polhode {

/// The charged sites of a range of slots of one molecule type.
struct MeshBodies {
  const std::vector<double>& charges;  ///< of the sites [e]
  std::size_t first, end;              ///< slots; `first` is a multiple of slot_block
};

/// A record of each charge: its place along x, y and z (base/pack_grid.hpp) and the charge [e].
struct ChargeRecord {
  static constexpr std::size_t stride = 4;
};

/// Charges to be placed on the grid, in blocks of slot_block bodies: within a block, the bodies of
/// the first site come first.
template <class T>
struct PlaceChargesJob {
  const Box& box;
  const SiteRecords<T>& records;
  MeshBodies bodies;
  std::array<std::size_t, 3> points;
  T* charges;         ///< records, also for the slots that fill the last block
  std::int32_t* row;  ///< of each charge: the grid point below it along y
  /// For derivatives: displacements laid out as `records`, and for each charge a record of its own
  /// displacement in grid spacings.
  const SiteRecords<T>* displacements = nullptr;
  T* moves = nullptr;
};

/// Charges that are spread over the grid. Each grid point receives their contributions in order.
template <class T>
struct SpreadJob {
  const T* charges;  ///< records
  const T* moves;    ///< of their displacements: each charge becomes a dipole; null without
  const std::uint32_t *order, *end;  ///< numbers of the charges
  int spline;                        ///< order of the spline
  MeshGrid<T>& grid;
};

/// Bodies on which the potential on the grid acts.
template <class T>
struct GatherJob {
  const Box& box;
  const SiteRecords<T>& records;
  MeshBodies bodies;
  int order;
  const MeshGrid<T>& grid;  ///< K times the potential of the charges [kJ/mol/e]
  T* sums;                  ///< accumulates force and torque of each slot, as in ChunkSums
  Mat3<double>* arms;       ///< accumulates Σ arm ⊗ force over sites; null if not needed
};

/// Bodies that are displaced while the potential changes.
template <class T>
struct GatherDerivativeJob {
  GatherJob<T> forces;  ///< without arms
  const SiteRecords<T>& displacements;
  const MeshGrid<T>& derivative;  ///< derivative of the grid along the displacement of all charges
};

POLHODE_DECLARE_LOOPS(
    /// Fills the records of charges.
    void place_charges(const PlaceChargesJob<double>& job);
    void place_charges(const PlaceChargesJob<float>& job);
    /// Adds charges to the grid.
    void spread_charges(const SpreadJob<double>& job);
    void spread_charges(const SpreadJob<float>& job);
    /// Adds the derivative of the charges along displacements to the grid.
    void spread_dipoles(const SpreadJob<double>& job);
    void spread_dipoles(const SpreadJob<float>& job);
    /// Adds forces and torques on some bodies to their sums.
    void gather_forces(const GatherJob<double>& job);
    void gather_forces(const GatherJob<float>& job);
    /// Adds the derivatives of forces and torques on some bodies to their sums.
    void gather_derivative(const GatherDerivativeJob<double>& job);
    void gather_derivative(const GatherDerivativeJob<float>& job);)

}  // namespace polhode
