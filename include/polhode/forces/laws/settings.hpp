// SPDX-License-Identifier: MIT
// Force field settings. All molecules interact by site-site Lennard-Jones and Coulomb forces in a
// periodic box; the settings choose the cutoff treatment and the precision of the pairs.
#pragma once

#include <limits>
#include <memory>
#include <optional>

#include "polhode/forces/external_forces.hpp"
#include "polhode/forces/laws/mixing.hpp"
#include "polhode/forces/mesh/mesh_settings.hpp"
#include "polhode/model/box.hpp"

namespace polhode {

/// Cutoff treatment. Smooth switches are needed because the energy error of a scheme of order p
/// contains the p-th derivative of the potential energy. A switch of class C^(p−1) keeps this p-th
/// derivative bounded (docs/statistics.md).
enum class Truncation {
  molecule_switch,  ///< all site pairs of two molecules are multiplied by w(R), where R is the
                    ///< distance between the centres of mass
  site_switch,      ///< each site pair is multiplied by w(r), where r is the distance between the
                    ///< sites
  site_shift,       ///< energy and force of each site pair are shifted to 0 at the cutoff
                    ///< [toxvaerd2011]
};

/// Methods for the electrostatic interactions.
enum class Electrostatics {
  coulomb,               ///< plain Coulomb potential
  reaction_field,        ///< Coulomb potential with a dielectric continuum beyond the cutoff
  pme,                   ///< smooth particle mesh Ewald: sums pairs within the cutoff, and the
                         ///< long-range remainder on a mesh
  damped_shifted_force,  ///< Coulomb potential, damped and shifted to 0 at the cutoff
};

/// Precision of the pair forces. Positions, orientations, momenta and all sums of forces, torques
/// and energies are always double.
enum class Precision {
  double_precision,  ///< pair forces in double precision
  mixed,             ///< pair forces in float, from fixed-point centres and relative site positions
};

struct ForceSettings {
  Truncation truncation = Truncation::molecule_switch;
  double cutoff = 1.0;        ///< cutoff of the pair interactions [nm]
  double switch_from = 0.85;  ///< start of the switching range [nm]
  int smoothness = 2;         ///< differentiability of the switch: C¹, C², C³
  Electrostatics electrostatics = Electrostatics::coulomb;
  double dielectric = 78.5;  ///< relative permittivity beyond the cutoff, for the reaction field;
                             ///< may be infinite
  double skin = 0.05;        ///< skin of the neighbour list [nm]
  Precision precision = Precision::double_precision;
  Mixing mixing{};  ///< mixing rule for the parameters of unlike sites
  /// Requested rms error of the electrostatic forces of PME, relative to the rms electrostatic
  /// force.
  double pme_accuracy = 1e-4;
  /// Distance up to which PME sums pairs of charges [nm]. If not set, this cutoff and the mesh are
  /// chosen together. `cutoff` applies only to the short-range potentials.
  std::optional<double> coulomb_cutoff{};
  double damping = 2;  ///< α of the damped shifted force [1/nm]
  /// α of Ewald's Gaussian split [1/nm], for PME with the mesh of another program. With this
  /// setting, the force field has no mesh and sums charge pairs up to the cutoff.
  std::optional<double> ewald_alpha{};
  /// The mesh of PME; if not set, the cheapest mesh that meets `pme_accuracy` is chosen for each
  /// box.
  std::optional<MeshSettings> mesh{};
  /// The box for which the mesh was chosen. If the user gave the mesh, this box is not set, and the
  /// mesh is the same in every box.
  std::optional<Box> mesh_chosen_for{};
  /// Whether to add the Lennard-Jones energy and pressure beyond the truncation, assuming a uniform
  /// density of sites.
  bool dispersion_correction = false;
  /// Whether to add the same, with forces, for a density of sites that depends on z, as in a slab
  /// of liquid with its surfaces normal to z.
  bool slab_dispersion = false;
  /// External forces, which are added to all other forces; null if there are none.
  std::shared_ptr<const ExternalForces> external{};
};

/// The cutoff of the pair interaction of two charges [nm].
inline double cutoff_of_charges(const ForceSettings& settings) {
  return settings.mesh ? settings.mesh->cutoff : settings.coulomb_cutoff.value_or(settings.cutoff);
}

/// The relative permittivity of the surroundings, on which the fluctuations of the total dipole
/// depend: infinite for PME; empty if the electrostatics is truncated or switched.
inline std::optional<double> permittivity_of_surroundings(const ForceSettings& settings) {
  switch (settings.electrostatics) {
    case Electrostatics::pme:
      return std::numeric_limits<double>::infinity();
    case Electrostatics::reaction_field:
      return settings.dielectric;
    case Electrostatics::coulomb:
    case Electrostatics::damped_shifted_force:
      return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace polhode
