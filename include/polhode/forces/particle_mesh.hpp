// SPDX-License-Identifier: MIT
// The smooth part of the electrostatics on a grid, in a time that grows with the number of charges
// [essmann1995]: charges are spread over grid points, the potential is a product of waves, and the
// forces are its exact gradient, so that mesh energy is conserved as any other.
#pragma once

#include <memory>
#include <vector>

#include "polhode/base/workers.hpp"
#include "polhode/forces/ewald_split.hpp"
#include "polhode/forces/mesh_loops.hpp"
#include "polhode/forces/mesh_settings.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// What the mesh does as a whole; 0 where energies are not asked for.
struct MeshLoad {
  double energy = 0;      ///< of the smooth part, over wave vectors [kJ/mol]
  Mat3<double> virial{};  ///< as in Load: −dE/dε for a strain that moves centres of bodies [kJ/mol]
};

/// What the smooth part has too much and does not depend on where bodies are: each charge with
/// itself, charges of one body with each other, and the mean of the short-range part with a net
/// charge [kJ/mol].
struct MeshConstant {
  double self = 0, intramolecular = 0, background = 0;
  Mat3<double> virial{};  ///< of the background
  double energy() const { return self + intramolecular + background; }

  MeshConstant(const Topology& topology, const CompactSplit& split, const Box& box);
};

/// @tparam T  in which the grid is computed: double or float
template <class T>
class ParticleMesh {
 public:
  /// @throws Error  if the grid has fewer points to an edge than a spline needs, or an order or an
  ///                exponent is out of its domain
  ParticleMesh(const Topology& topology, const MeshSettings& settings, const Box& box,
               Workers& workers = Workers::serial());
  ~ParticleMesh();

  /// Adds forces and torques to `sums`, a record for each slot as in ChunkSums; the energy and the
  /// virial if wanted. The same bits for any number of threads. Does not allocate.
  MeshLoad operator()(const Slots& slots, const SiteRecords<T>& records, T* sums, bool energies);

  // Its three parts, in this order:
  /// Charges to the grid.
  void spread(const Slots& slots, const SiteRecords<T>& records);
  /// The potential of the charges on the grid; its energy, and the virial of a strain that moves
  /// charges with the box.
  MeshLoad convolve(bool energies);
  /// Forces and torques to `sums`; Σ arm ⊗ force over all sites if wanted.
  Mat3<double> gather(const Slots& slots, const SiteRecords<T>& records, T* sums, bool arms);

  /// Adds the derivatives of forces and torques along a displacement to `sums`.
  /// @param displacements  of centres and sites, as records
  /// @param charges_moved  whether charges moved since their potential was computed: then it is
  ///                       computed anew
  void derivative(const Slots& slots, const SiteRecords<T>& records,
                  const SiteRecords<T>& displacements, T* sums, bool charges_moved);

  const MeshSettings& settings() const { return settings_; }

 private:
  struct Field;  // a grid that holds charges at first, then their potential; and its transform
  struct Part {
    std::vector<double> charges;
    double reach;                        // of a charge from its centre [nm]
    std::vector<std::uint64_t> reached;  // groups of planes, for the plane of the centre
  };
  struct Axis {
    std::vector<double> k, odd;  // wave number, and 0 in its place where k and −k are the same wave
  };
  void make_influence();
  void find_extents(const Slots& slots, const SiteRecords<T>& records);
  // With displacements, their derivative.
  void spread_on(Field& field, const Slots& slots, const SiteRecords<T>& records,
                 const SiteRecords<T>* displacements);
  void spread_to(Field& field, std::size_t slab, const Slots& slots, const SiteRecords<T>& records,
                 const SiteRecords<T>* displacements);
  MeshLoad convolve_on(Field& field, bool energies);
  void convolve_row(Field& field, std::size_t y, T* waves, const T** rows, WaveSums* sums);
  template <class Gather>
  void each_charged_block(const Slots& slots, const Gather& gather);

  Workers& workers_;
  MeshSettings settings_;
  Box box_;
  std::vector<Part> parts_;
  std::unique_ptr<Field> field_;
  std::unique_ptr<Field> derivative_;  // of the field; once it is asked for
  bool has_potential_ = false;
  std::array<Axis, 3> axes_;
  // Of a row of waves: as in ConvolveJob.
  Column<T> weight_, kx_, kx_squared_;
  // For |k_y| and |k_z|, a row each.
  Column<T> influence_, slope_;
  // Which planes the slots of a block reach, a bit for each group of planes.
  std::vector<std::uint64_t> extents_;
  struct Slab {
    std::uint64_t groups;
    std::vector<std::ptrdiff_t> plane_at;
    std::size_t first, end;  // planes
  };
  std::vector<Slab> slabs_;
  struct Space {  // of a task
    Column<T> waves;
    std::vector<const T*> rows;
    std::vector<WaveSums> sums;
  };
  std::vector<Space> spaces_;
  std::vector<MeshLoad> loads_;     // of each y
  std::vector<Mat3<double>> arms_;  // of each task
};

}  // namespace polhode
