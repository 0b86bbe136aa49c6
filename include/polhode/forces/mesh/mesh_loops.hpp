// SPDX-License-Identifier: MIT
// The loops of the particle mesh, compiled once per instruction set.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "polhode/base/column.hpp"
#include "polhode/base/instruction_set.hpp"
#include "polhode/forces/pairs/pair_loops.hpp"

namespace polhode {

/// Numbers on the points of a grid over the box, x fastest. Each row is padded with an overhang
/// that holds its periodic continuation, so that eight consecutive numbers can be read and written
/// from any point.
template <class T>
struct MeshGrid {
  static constexpr std::size_t overhang = 7;

  std::array<std::size_t, 3> points{};
  std::size_t row = 0, plane = 0;  ///< distance between rows and between planes, in numbers
  Column<T> values;
  /// Where row y and plane z begin, also for y and z up to `overhang` beyond the end.
  std::vector<std::ptrdiff_t> row_at, plane_at;

  MeshGrid() = default;
  explicit MeshGrid(const std::array<std::size_t, 3>& grid_points);
};

/// The charged sites of a range of slots of one molecule type.
struct MeshBodies {
  const std::vector<double>& charges;  ///< of the sites [e]
  std::size_t first, end;              ///< slots; `first` is a multiple of slot_block
};

/// Bodies whose charges are spread over the grid. Each grid point receives its contributions in the
/// order of slots, whichever planes a job covers.
template <class T>
struct SpreadJob {
  const Box& box;
  const SiteRecords<T>& records;
  MeshBodies bodies;
  int order;
  MeshGrid<T>& grid;
  const std::ptrdiff_t* plane_at;  ///< as in the grid; negative for a plane that this job skips
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

/// Bodies whose charges are displaced: each charge becomes a dipole, the derivative of its
/// contributions to the grid.
template <class T>
struct SpreadDipolesJob {
  SpreadJob<T> charges;
  const SiteRecords<T>& displacements;
};

/// Bodies that are displaced while the potential changes.
template <class T>
struct GatherDerivativeJob {
  GatherJob<T> forces;  ///< without arms
  const SiteRecords<T>& displacements;
  const MeshGrid<T>& derivative;  ///< derivative of the grid along the displacement of all charges
};

/// Fourier coefficients of one k_y: rows along k_x, one per k_z; real and imaginary alternate.
template <class T>
struct ConvolveJob {
  T* modes;
  std::size_t row, rows;              ///< numbers per row, in whole packs
  const T* const* influence;          ///< for each row: factors of the coefficients, each twice
  const T* const* slope;              ///< for each row: H in virial = ½ Σ |S|² (G + H k ⊗ k)
  const T *weight, *kx, *kx_squared;  ///< along a row; weight: 2 for a coefficient that represents
                                      ///< k and −k, else 1
};

/// ½ Σ G |S|² and ½ Σ H |S|² k_x^a of each row, weighted.
struct ModeSums {
  double energy = 0, slope = 0, slope_x = 0, slope_xx = 0;
};

POLHODE_DECLARE_LOOPS(
    /// Adds the charges of some bodies to the grid.
    void spread_charges(const SpreadJob<double>& job);
    void spread_charges(const SpreadJob<float>& job);
    /// Adds forces and torques on some bodies to their sums.
    void gather_forces(const GatherJob<double>& job);
    void gather_forces(const GatherJob<float>& job);
    /// Adds the derivative of the charges along displacements to the grid.
    void spread_dipoles(const SpreadDipolesJob<double>& job);
    void spread_dipoles(const SpreadDipolesJob<float>& job);
    /// Adds the derivatives of forces and torques on some bodies to their sums.
    void gather_derivative(const GatherDerivativeJob<double>& job);
    void gather_derivative(const GatherDerivativeJob<float>& job);
    /// Multiplies by the influence function; with `sums`, also computes the energies of each row.
    void convolve(const ConvolveJob<double>& job, ModeSums* sums);
    void convolve(const ConvolveJob<float>& job, ModeSums* sums);)

}  // namespace polhode
