// SPDX-License-Identifier: MIT
// The kinds of rigid molecules of a LAMMPS system: molecules whose atoms have the same types and
// masses in the order of their ids, or particles of one type, each of which is a molecule.
#pragma once

#include <cstdint>
#include <vector>

#include "body_columns.hpp"
#include "molecule_file.hpp"
#include "polhode/model/molecule.hpp"

namespace polhode::lammps {

/// An atom of a molecule as LAMMPS has it; without mass if it only carries a charge.
struct SiteAtom {
  std::int64_t id = 0;
  int type = 0;
  double mass = 0;
  Vec3<double> x{}, v{};  ///< with all atoms of a molecule in one periodic image
};

/// The smallest deviation from the rigid shape that is refused, relative to the span of the
/// molecule, unless the keyword `tolerance` sets another: coordinates with three decimals in Å, and
/// those of flexible molecules with stiff bonds, are within it.
inline constexpr double default_tolerance = 0.02;

struct Kind {
  std::vector<int> types;  ///< of its sites: of atoms, in the order of their ids
  Molecule molecule;       ///< its sites in the same order
  int particle = 0;        ///< the type of its particles; 0: each of its sites is an atom
  // Of particles: the charges of their sites, and the rotation from the principal frame to that of
  // the molecule file, in which LAMMPS has their orientations.
  std::vector<double> charges;
  Quaternion<double> frame{};
  std::int64_t first = 0;  ///< the molecule that its shape was taken from
  std::size_t owner = 0;   ///< the site nearest to the centre: its process advances the body
  double span = 0;         ///< largest distance of a site from the owner
  double extent = 0;       ///< largest distance of a site from the centre
  Vec3<double> site(std::size_t k) const { return molecule.sites[k].r; }
  /// The place of the k-th atom; a particle is at the centre.
  Vec3<double> atom(std::size_t k) const { return particle != 0 ? Vec3<double>{} : site(k); }
};

/// The kind of a molecule with the shape that the atoms have.
/// @param number  of the molecule; negative for an atom without one, minus its id
/// @throws Error  if the molecule has no mass, or more sites than a rigid molecule may have
Kind kind_of(std::int64_t number, const std::vector<SiteAtom>& atoms);

/// The kind of particles of a type.
/// @param masses  of the sites
/// @throws Error  if a mass is negative, or as the other one
Kind kind_of_particles(int type, const MoleculeFile& file, const std::vector<double>& masses);

/// Whether atoms have the types and masses of a kind.
bool matches(const Kind& kind, const std::vector<SiteAtom>& atoms);

/// The kind as numbers, for other processes and restart files, and back.
void append(std::vector<double>& numbers, const Kind& kind);
Kind read_kind(const double*& numbers);

/// The body of a kind that fits the atoms best; momenta are the sums over the atoms.
BodyRecord fitted_body(const Kind& kind, const std::vector<SiteAtom>& atoms);

/// Position and velocity of an atom of a body.
Vec3<double> position(const Kind& kind, std::size_t atom, const Pose& pose);
Vec3<double> velocity(const Kind& kind, std::size_t atom, const BodyRecord& body);

double rotational_energy(const Kind& kind, const BodyRecord& body);  ///< L · J⁻¹ L/2

/// Checks that every atom is where the body has it.
/// @throws Error  with the numbers of molecule and atom, if it is farther than tolerance × span
void check_shape(const Kind& kind, std::int64_t number, const std::vector<SiteAtom>& atoms,
                 const BodyRecord& body, double tolerance);

/// A body that agrees with the atoms: the one given, in the image of the atoms, if its sites and
/// their velocities agree to 1e-9, much more than what rounding changes, otherwise the one that
/// fits, as after commands that set positions or velocities.
BodyRecord updated_body(const Kind& kind, const std::vector<SiteAtom>& atoms,
                        const BodyRecord& before);

/// A particle as LAMMPS has it; the orientation is that of the molecule in its file.
struct Particle {
  Vec3<double> x{}, v{};
  Quaternion<double> orientation;
  Vec3<double> ell{};
};
Quaternion<double> orientation_of_particle(const Kind& kind, const Pose& pose);

/// The body of a particle: the one given, in the image of the particle, as far as it agrees with it
/// to 1e-9, otherwise with the numbers of the particle.
/// @throws Error  if the orientation is not that of a rotation; `id` is that of the particle
BodyRecord body_of_particle(const Kind& kind, const Particle& particle, const BodyRecord* before,
                            std::int64_t id);

}  // namespace polhode::lammps
