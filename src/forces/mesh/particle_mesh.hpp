// SPDX-License-Identifier: MIT
// Particle mesh for the smooth part of the electrostatics, whose cost is nearly linear in the
// number of charges [essmann1995]. Charges are spread over the grid, and the potential is computed
// as a product in reciprocal space. The forces are the exact gradient of the energy, so the mesh
// conserves energy like any other force.
#pragma once

#include <memory>
#include <vector>

#include "forces/mesh/mesh_charges.hpp"
#include "polhode/base/workers.hpp"
#include "polhode/forces/mesh/mesh_settings.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// Total energy and virial of the mesh; 0 if energies are not requested.
struct MeshLoad {
  double energy = 0;      ///< energy of the smooth part, summed over wave vectors [kJ/mol]
  Mat3<double> virial{};  ///< virial as in Load: −dE/dε for a strain that moves the centres of
                          ///< bodies [kJ/mol]
};

/// The particle mesh, which computes the smooth part of the electrostatic energy.
/// @tparam T  precision of the grid: double or float
template <class T>
class ParticleMesh {
 public:
  /// @throws Error  if the number of grid points along an edge is too small for a spline or not a
  ///   multiple of mesh_multiple, or if an order or exponent is out of its domain
  ParticleMesh(const Topology& topology, const MeshSettings& settings, const Box& box,
               Workers& workers = Workers::serial());
  ~ParticleMesh();

  /// Sets another box with the same number of grid points, and discards the potential.
  void set_box(const Box& box);

  /// Adds forces and torques to `sums`, with a record per slot as in ChunkSums. If requested, the
  /// function also computes the energy and the virial. Results are bitwise identical for any number
  /// of threads. The function does not allocate memory.
  MeshLoad operator()(const Slots& slots, const SiteRecords<T>& records, T* sums, bool energies);

  // The following three functions are the steps of an evaluation, in the order of their calls.
  /// Spreads the charges onto the grid.
  void spread(const Slots& slots, const SiteRecords<T>& records);
  /// Replaces the charges on the grid by their potential. Returns the energy, and the virial of a
  /// strain that moves charges with the box.
  MeshLoad convolve(bool energies);
  /// Adds forces and torques to `sums`; returns Σ arm ⊗ force over all sites if requested.
  Mat3<double> gather(const Slots& slots, const SiteRecords<T>& records, T* sums, bool arms);

  /// Adds the derivatives of forces and torques along a displacement to `sums`.
  /// @param displacements  displacements of centres and sites, with the layout of the records
  /// @param charges_moved  whether charges have moved since the last computation of the potential,
  ///   so that the potential must be computed again
  void derivative(const Slots& slots, const SiteRecords<T>& records,
                  const SiteRecords<T>& displacements, T* sums, bool charges_moved);

  const MeshSettings& settings() const { return settings_; }

 private:
  struct Plans;  // plans of the Fourier transforms
  struct Field;  // grid with the charges and later with the potential, and its Fourier coefficients
  struct Axis {
    std::vector<double> k, odd;  // wave numbers; `odd` is the same, but 0 if k and −k are the same
                                 // wave
  };
  // Factors of the mesh that depend on the box.
  struct Factors {
    Box box{};
    std::array<Axis, 3> axes;
    Column<T> influence, slope;  // for each column of coefficients, a pack for each k_y ≥ 0
  };
  void use_tiles();
  Factors factors_of(const Box& box);
  // Spreads the charges or, if displacements are given, the derivative of the charges.
  void spread_on(Field& field, const Slots& slots, const SiteRecords<T>& records,
                 const SiteRecords<T>* displacements);
  MeshLoad convolve_on(Field& field, bool energies);
  void convolve_column(Field& field, std::size_t column, bool energies);
  template <class Gather>
  void each_charged_block(const Slots& slots, const Gather& gather);

  Workers& workers_;
  MeshSettings settings_;
  MeshCharges<T> charges_;
  std::unique_ptr<Plans> plans_;
  std::unique_ptr<Field> field_;
  std::unique_ptr<Field> derivative_;  // derivative of the field; allocated when it is first
                                       // requested
  bool has_potential_ = false;
  Factors factors_;
  Factors earlier_;  // factors of the previous box, to which a barostat returns after a rejected
                     // move
  std::vector<MeshLoad> loads_;     // loads of each column
  std::vector<Mat3<double>> arms_;  // arms of each task
};

}  // namespace polhode
