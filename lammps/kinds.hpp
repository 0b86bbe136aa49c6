// SPDX-License-Identifier: MIT
// The kinds of rigid molecules of a LAMMPS system. All molecules of a kind have the same atom types
// and masses, in the order of atom ids. All particles of the same type are also one kind, because
// each particle is a molecule.
#pragma once

#include <cstdint>
#include <vector>

#include "body_columns.hpp"
#include "molecule_file.hpp"
#include "polhode/model/molecule.hpp"

namespace polhode::lammps {

/// An atom of a molecule in LAMMPS. A site that only carries a charge is massless.
struct SiteAtom {
  std::int64_t id = 0;
  int type = 0;
  double mass = 0;
  Vec3<double> x{}, v{};  ///< position and velocity; all atoms of a molecule are in one periodic
                          ///< image
};

/// The default of the keyword `tolerance`: the largest accepted deviation from the rigid shape,
/// relative to the span of the molecule. Coordinates with three decimals in Å meet this tolerance,
/// and so do flexible molecules with stiff bonds.
inline constexpr double default_tolerance = 0.02;

struct Kind {
  std::vector<int> types;  ///< atom types of the sites of the kind, in the order of atom ids
  Molecule molecule;       ///< molecule with its sites in the same order
  int particle = 0;        ///< atom type of the particles of the kind; 0 if each site is an atom
  // Only for particles: the charges of the sites, and the rotation from the principal frame to the
  // frame of the molecule file. LAMMPS orientations refer to the frame of the molecule file.
  std::vector<double> charges;
  Quaternion<double> frame{};
  std::int64_t first = 0;  ///< number of the molecule from which the shape was taken
  std::size_t owner = 0;   ///< site nearest to the centre; the process of this atom advances the
                           ///< body
  double span = 0;         ///< largest distance of a site from the owner site
  double extent = 0;       ///< largest distance of a site from the centre
  Vec3<double> site(std::size_t k) const { return molecule.sites[k].r; }
  /// The body-frame position of the k-th atom; a particle is at the centre.
  Vec3<double> atom(std::size_t k) const { return particle != 0 ? Vec3<double>{} : site(k); }
};

/// Makes the kind of a molecule with the shape given by its atoms.
/// @param number  number of the molecule, or minus the id of an atom without a molecule
/// @throws Error  if the molecule has no mass, or more sites than a rigid molecule may have
Kind kind_of(std::int64_t number, const std::vector<SiteAtom>& atoms);

/// Makes the kind of the particles of a type.
/// @param masses  masses of the sites
/// @throws Error  if a mass is negative, or under the same conditions as kind_of()
Kind kind_of_particles(int type, const MoleculeFile& file, const std::vector<double>& masses);

/// Whether atoms agree with the types and masses of a kind.
bool matches(const Kind& kind, const std::vector<SiteAtom>& atoms);

/// Converts a kind to numbers and back, for other processes and restart files.
void append(std::vector<double>& numbers, const Kind& kind);
Kind read_kind(const double*& numbers);

/// Fits a body of a kind to the atoms. The momenta of the body are sums over the atoms.
BodyRecord fitted_body(const Kind& kind, const std::vector<SiteAtom>& atoms);

/// The position and velocity of an atom of a body.
Vec3<double> position(const Kind& kind, std::size_t atom, const Pose& pose);
Vec3<double> velocity(const Kind& kind, std::size_t atom, const BodyRecord& body);

double rotational_energy(const Kind& kind, const BodyRecord& body);  ///< The kinetic energy of
                                                                     ///< rotation, L · J⁻¹ L/2.

/// Checks that every atom is at its site in the body.
/// @throws Error  with the numbers of molecule and atom, if the distance exceeds tolerance × span
void check_shape(const Kind& kind, std::int64_t number, const std::vector<SiteAtom>& atoms,
                 const BodyRecord& body, double tolerance);

/// A body that agrees with the positions and velocities of its atoms. If the sites of the given
/// body agree with the atoms to 1e-9 in position and velocity, the result is the given body, in the
/// periodic image of the atoms. This tolerance is well above round-off. Otherwise, for example
/// after commands that set positions or velocities, the result is a body fitted to the atoms.
BodyRecord updated_body(const Kind& kind, const std::vector<SiteAtom>& atoms,
                        const BodyRecord& before);

/// A particle, with the position, velocity, orientation and angular momentum that LAMMPS stores.
/// The orientation of the particle refers to the frame of the molecule file.
struct Particle {
  Vec3<double> x{}, v{};
  Quaternion<double> orientation;
  Vec3<double> ell{};
};
Quaternion<double> orientation_of_particle(const Kind& kind, const Pose& pose);

/// The body of a particle. Values of the given body that agree with the particle to 1e-9 are kept,
/// in the periodic image of the particle. All other values are taken from the particle.
/// @throws Error  with the `id` of the particle, if its orientation is not a rotation
BodyRecord body_of_particle(const Kind& kind, const Particle& particle, const BodyRecord* before,
                            std::int64_t id);

}  // namespace polhode::lammps
