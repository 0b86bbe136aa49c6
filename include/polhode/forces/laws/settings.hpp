// SPDX-License-Identifier: MIT
// Force field settings. All molecules interact by site-site Lennard-Jones and Coulomb forces in a
// periodic box; the settings choose the cutoff treatment and the precision of the pairs.
#pragma once

#include <memory>
#include <optional>

#include "polhode/forces/external_forces.hpp"
#include "polhode/forces/laws/mixing.hpp"
#include "polhode/forces/mesh/mesh_settings.hpp"
#include "polhode/model/box.hpp"

namespace polhode {

/// Cutoff treatment. The switches are smooth: the energy error of a scheme of order p contains the
/// p-th derivative of the energy, which is bounded from smoothness p − 1 on (docs/statistics.md).
enum class Truncation {
  molecule_switch,  ///< w(R) times all site pairs of two molecules, R between centres of mass
  site_switch,      ///< w(r) times each site pair, r between the sites
  site_shift,       ///< each site pair with its energy and force shifted to 0 at the cutoff
                    ///< [toxvaerd2011]
};

/// Electrostatics.
enum class Electrostatics {
  coulomb,               ///< plain Coulomb law
  reaction_field,        ///< Coulomb's law with a dielectric continuum beyond the cutoff
  pme,                   ///< smooth particle mesh: pairs within the cutoff, the long-range rest on
                         ///< a mesh
  damped_shifted_force,  ///< damped Coulomb law, shifted to 0 at the cutoff
};

/// Precision of the pairs. Positions, orientations, momenta and all sums of forces, torques and
/// energies are double in either case.
enum class Precision {
  double_precision,  ///< pairs in double
  mixed,             ///< pairs in float: sites relative to centres, centres in fixed point
};

struct ForceSettings {
  Truncation truncation = Truncation::molecule_switch;
  double cutoff = 1.0;        ///< [nm]
  double switch_from = 0.85;  ///< start of the switching range [nm]
  int smoothness = 2;         ///< differentiability of the switch: C¹, C², C³
  Electrostatics electrostatics = Electrostatics::coulomb;
  double dielectric = 78.5;  ///< relative permittivity beyond the cutoff, for the reaction field;
                             ///< may be infinite
  double skin = 0.05;        ///< skin of the neighbour list [nm]
  Precision precision = Precision::double_precision;
  Mixing mixing{};  ///< Lennard-Jones parameters of unlike sites
  /// Rms error of the electrostatic forces of PME relative to their rms.
  double pme_accuracy = 1e-4;
  /// For PME, distance up to which pairs of charges are summed [nm]; if not set, this cutoff and
  /// the mesh are chosen together. `cutoff` is for the short-range laws.
  std::optional<double> coulomb_cutoff{};
  double damping = 2;  ///< α of the damped shifted force [1/nm]
  /// α of Ewald's Gaussian split [1/nm], for PME with the mesh of another program. The force field
  /// then has no mesh, and sums pairs up to the cutoff.
  std::optional<double> ewald_alpha{};
  /// The mesh of PME; if not set, the cheapest mesh of that accuracy is chosen for each box.
  std::optional<MeshSettings> mesh{};
  /// The box for which the mesh was chosen; not set for a mesh that was given, which is kept in
  /// every box.
  std::optional<Box> mesh_chosen_for{};
  /// Whether to add the Lennard-Jones energy and pressure beyond the truncation, assuming a uniform
  /// density of sites.
  bool dispersion_correction = false;
  /// External forces, added to all others; null: none.
  std::shared_ptr<const ExternalForces> external{};
};

/// Two charges farther apart do not interact as a pair [nm].
inline double cutoff_of_charges(const ForceSettings& settings) {
  return settings.mesh ? settings.mesh->cutoff : settings.coulomb_cutoff.value_or(settings.cutoff);
}

}  // namespace polhode
