// SPDX-License-Identifier: MIT
// Particle mesh for the smooth part of the electrostatics, in a time nearly linear in the number of
// charges [essmann1995]: charges are spread over the grid, the potential is a product in reciprocal
// space, and the forces are its exact gradient, so that the mesh conserves energy as any other
// force does.
#pragma once

#include <memory>
#include <vector>

#include "forces/laws/ewald_split.hpp"
#include "forces/mesh/mesh_charges.hpp"
#include "polhode/base/workers.hpp"
#include "polhode/forces/mesh/mesh_settings.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// Total energy and virial of the mesh; 0 if energies are not requested.
struct MeshLoad {
  double energy = 0;      ///< of the smooth part, summed over wave vectors [kJ/mol]
  Mat3<double> virial{};  ///< as in Load: −dE/dε for a strain that moves the centres of bodies
                          ///< [kJ/mol]
};

/// Corrections of the smooth part that do not depend on the positions of bodies: self-energy of
/// each charge, exclusion of charges within the same body, and the uniform background that
/// neutralizes a net charge [kJ/mol].
struct MeshConstant {
  double self = 0, intramolecular = 0, background = 0;
  Mat3<double> virial{};  ///< of the background
  double energy() const { return self + intramolecular + background; }

  MeshConstant(const Topology& topology, const CompactSplit& split, const Box& box);
};

/// @tparam T  precision of the grid: double or float
template <class T>
class ParticleMesh {
 public:
  /// @throws Error  if an edge has fewer grid points than a spline needs or not a multiple of
  ///                mesh_multiple, or an order or an exponent is out of its domain
  ParticleMesh(const Topology& topology, const MeshSettings& settings, const Box& box,
               Workers& workers = Workers::serial());
  ~ParticleMesh();

  /// Sets another box, for the same grid points, and discards the potential.
  void set_box(const Box& box);

  /// Adds forces and torques to `sums`, one record per slot as in ChunkSums; computes the energy
  /// and the virial if requested. Bitwise identical for any number of threads. Does not allocate.
  MeshLoad operator()(const Slots& slots, const SiteRecords<T>& records, T* sums, bool energies);

  // Its three steps, in this order:
  /// Spreads the charges onto the grid.
  void spread(const Slots& slots, const SiteRecords<T>& records);
  /// Replaces the charges on the grid by their potential; returns its energy, and the virial of a
  /// strain that moves charges with the box.
  MeshLoad convolve(bool energies);
  /// Adds forces and torques to `sums`; returns Σ arm ⊗ force over all sites if requested.
  Mat3<double> gather(const Slots& slots, const SiteRecords<T>& records, T* sums, bool arms);

  /// Adds the derivatives of forces and torques along a displacement to `sums`.
  /// @param displacements  of centres and sites, laid out as the records
  /// @param charges_moved  whether charges moved since their potential was computed, which is then
  ///                       computed again
  void derivative(const Slots& slots, const SiteRecords<T>& records,
                  const SiteRecords<T>& displacements, T* sums, bool charges_moved);

  const MeshSettings& settings() const { return settings_; }

 private:
  struct Plans;  // of the Fourier transforms
  struct Field;  // grid with the charges, later with their potential; and its coefficients
  struct Axis {
    std::vector<double> k, odd;  // wave number; odd: the same, but 0 where k and −k are the same
                                 // wave
  };
  // What depends on the box.
  struct Factors {
    Box box{};
    std::array<Axis, 3> axes;
    Column<T> influence, slope;  // for each column of coefficients, a pack for each k_y ≥ 0
  };
  void use_tiles();
  Factors factors_of(const Box& box);
  // With displacements, spreads the derivative of the charges.
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
  std::unique_ptr<Field> derivative_;  // of the field; allocated when it is first requested
  bool has_potential_ = false;
  Factors factors_;
  Factors earlier_;  // of the box before: after a rejected move, a barostat returns to it
  std::vector<MeshLoad> loads_;     // of each column
  std::vector<Mat3<double>> arms_;  // of each task
};

}  // namespace polhode
