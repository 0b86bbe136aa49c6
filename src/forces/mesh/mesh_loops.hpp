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
  const std::vector<double>& charges;  ///< charges of the sites [e]
  std::size_t first, end;              ///< slots; `first` is a multiple of slot_block
};

/// The record of a charge: its place along x, y and z (base/pack_grid.hpp) and the charge [e].
struct ChargeRecord {
  static constexpr std::size_t stride = 4;
};

/// A job that places charges on the grid, in blocks of slot_block bodies. Each block contains the
/// charges of the first site of all bodies, followed by the charges of the second site, and so on.
template <class T>
struct PlaceChargesJob {
  const Box& box;
  const SiteRecords<T>& records;
  MeshBodies bodies;
  std::array<std::size_t, 3> points;
  T* charges;         ///< records of charges, including padding slots in the last block
  std::int32_t* row;  ///< index along y of the grid point below each charge
  /// Only for derivatives: displacements with the layout of `records`, and for each charge a record
  /// of the displacement in grid spacings.
  const SiteRecords<T>* displacements = nullptr;
  T* moves = nullptr;
};

/// A job that spreads charges over the grid. Each grid point receives the contributions of charges
/// in a fixed order.
template <class T>
struct SpreadJob {
  const T* charges;  ///< records of charges
  const T* moves;    ///< records of displacements, by which each charge becomes a dipole; null if
                     ///< charges do not move
  const std::uint32_t *order, *end;  ///< numbers of the charges
  int spline;                        ///< order of the spline
  MeshGrid<T>& grid;
};

/// A job that computes the forces on bodies from the potential on the grid.
template <class T>
struct GatherJob {
  const Box& box;
  const SiteRecords<T>& records;
  MeshBodies bodies;
  int order;
  const MeshGrid<T>& grid;  ///< K times the potential of the charges [kJ/mol/e]
  T* sums;                  ///< accumulates force and torque of each slot, as in ChunkSums
  Mat3<double>* arms;       ///< accumulates Σ arm ⊗ force over all sites; null if not needed
};

/// A job that computes the derivatives of forces along a displacement of the bodies, including the
/// change of the potential.
template <class T>
struct GatherDerivativeJob {
  GatherJob<T> forces;  ///< job that gathers the forces; its `arms` is null
  const SiteRecords<T>& displacements;
  const MeshGrid<T>& derivative;  ///< derivative of the potential along the displacement of all
                                  ///< charges
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
    /// Adds forces and torques on some bodies to the sums of these bodies.
    void gather_forces(const GatherJob<double>& job);
    void gather_forces(const GatherJob<float>& job);
    /// Adds the derivatives of forces and torques on some bodies to the sums of these bodies.
    void gather_derivative(const GatherDerivativeJob<double>& job);
    void gather_derivative(const GatherDerivativeJob<float>& job);)

}  // namespace polhode
