// SPDX-License-Identifier: MIT
// The heat flux and the virials of molecules, of the particle mesh.
#pragma once

#include <complex>
#include <vector>

#include "forces/mesh/mesh_influence.hpp"
#include "forces/pairs/pair_heat_flux.hpp"
#include "polhode/forces/mesh/mesh_settings.hpp"
#include "polhode/model/box.hpp"
#include "polhode/model/molecule.hpp"

namespace polhode {

/// The heat flux of the smooth part of the electrostatics. Half of the energy of each pair of
/// charges belongs to each charge.
///
/// The lattice sum of r_ab ⊗ F_ab over two charges a and b is −∂/∂ε of their energy, with the
/// factors G and H of InfluenceValue. With R_ij = r_ab − d_a + d_b for arms d, the flux is
///
///   Σ_i e_i v_i + ½ Σ_a [q_a φ_a v_a − d_a (F_a·v_a) − d_a q_a χ_a] + ½ Σ_k H k Im(dS/dt S*),
///
/// where φ is the potential, and χ the change of the potential with time at a fixed point.
class MeshHeatFlux {
 public:
  /// @param molecule  the only kind of molecule
  MeshHeatFlux(const Molecule& molecule, const MeshSettings& settings, const Box& box);

  /// The flux without constant energies of each body [kJ/mol nm/ps].
  Vec3<double> operator()(const Motion& motion);
  /// Adds the virials of the bodies along each axis [kJ/mol].
  void add_virials(const Motion& motion, Vec3Column& virials);

 private:
  using Grid = std::vector<double>;
  /// A charge, its velocity, and its weights on the grid.
  struct Charge {
    std::array<std::size_t, 3> first;
    std::array<std::array<double, MeshSettings::max_order>, 3> weight, slope;  // slope [1/nm]
  };
  Charge place(const Vec3<double>& position) const;
  template <class Visit>
  void each_point(const Charge& charge, const Visit& visit) const;
  void transform(const Grid& grid, std::vector<std::complex<double>>& modes) const;
  void transform_back(const std::vector<std::complex<double>>& modes, Grid& grid) const;
  Vec3<double> convolve();
  template <class Factor>
  Grid convolved(const Factor& factor);

  MeshSettings settings_;
  Box box_;
  std::vector<double> charge_;  // of each charged site [e]
  std::array<std::vector<double>, 3> odd_k_, k_;
  std::vector<InfluenceValue> influence_;  // for all k with k_z ≥ 0
  Grid potential_, change_;                // charges and their change with time; later φ and χ
  std::vector<std::complex<double>> modes_, change_modes_;
};

}  // namespace polhode
