// SPDX-License-Identifier: MIT
// This part of fix polhode handles particles, each of which is a whole molecule. LAMMPS stores
// centres and velocities as for atoms, and orientations and angular momenta in columns of fix
// property/atom.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix_polhode.hpp"
#include "guarded.hpp"
#include "lammps_vectors.hpp"

namespace polhode::lammps {
namespace {

constexpr const char* orientation_name = "orientation";
constexpr const char* angular_momentum_name = "angular_momentum";
// Relative tolerance for the mass of a particle compared with the total mass of its sites. Input
// files round both masses.
constexpr double same_mass = 1e-6;

// Whether two kinds of particles are the same up to rounding in files.
bool same_kind(const Kind& a, const Kind& b) {
  if (a.types != b.types || a.charges != b.charges) return false;
  for (std::size_t k = 0; k < a.types.size(); ++k)
    if (norm(a.site(k) - b.site(k)) > 1e-9 * a.extent) return false;
  return a.molecule.mass == b.molecule.mass;
}

}  // namespace

/// Adds the kinds that molecule files define. In the list of kinds, particles precede molecules
/// that consist of atoms.
void FixPolhode::find_kinds_of_particles() {
  for (const ParticleArguments& particle : settings_.particles) {
    std::vector<double> masses = particle.file.masses;
    if (masses.empty())
      for (const int type : particle.file.types)
        masses.push_back(is_massless(type) ? 0 : atom->mass[type]);
    const Kind kind = [&] {
      try {
        return kind_of_particles(particle.type, particle.file, masses);
      } catch (const Error& e) {
        throw e.at(particle.path);
      }
    }();
    const double mass = atom->mass[particle.type];
    if (std::abs(mass - kind.molecule.mass) > same_mass * mass)
      throw Error("particles of type " + std::to_string(particle.type) + " have a mass of " +
                  std::to_string(mass) + ", and the sites in '" + particle.path + "' of " +
                  std::to_string(kind.molecule.mass) +
                  "; both masses must be equal, so set the mass of the type with 'mass'");
    const auto known = std::find_if(kinds_.begin(), kinds_.end(),
                                    [&](const Kind& k) { return k.particle == particle.type; });
    if (known == kinds_.end()) {
      kinds_.push_back(kind);
    } else if (!same_kind(*known, kind)) {
      throw Error("the sites in '" + particle.path +
                  "' differ from the sites in the restart file or in an earlier run; bodies cannot "
                  "change shape during a simulation, so use the earlier molecule file");
    }
  }
}

/// The kind of a particle in the group; −1 if an atom is not a particle of the group.
int FixPolhode::kind_of_particle(int i) const {
  if ((atom->mask[i] & groupbit) == 0) return -1;
  for (std::size_t k = 0; k < kinds_.size(); ++k)
    if (kinds_[k].particle == atom->type[i]) return static_cast<int>(k);
  return -1;
}

/// Makes the body of a particle from the data that LAMMPS stores. The body is in the periodic image
/// of the particle.
BodyRecord FixPolhode::body_of_particle(int i, const Kind& kind) {
  const double* const a = particle_column(orientation_name, 4)[i];
  const Vec3<double> x = vector(atom->x[i]);
  const Particle particle{x,
                          vector(atom->v[i]),
                          {a[0], a[1], a[2], a[3]},
                          vector(particle_column(angular_momentum_name, 3)[i])};
  BodyRecord body;
  const bool known = body_of(i) >= 0;
  if (known) {
    body = record(body_of(i));
    body.pose.q += x - body.pose.q - minimum_image(x - body.pose.q);
    if (phase_ != 0) return body;  // a particle may be displaced within a step
  }
  try {
    return lammps::body_of_particle(kind, particle, known ? &body : nullptr, atom->tag[i]);
  } catch (const Error& e) {
    error->one(FLERR, std::string("fix polhode: ") + e.what());
  }
  return body;
}

/// Warns if particles move but do not rotate, as after 'velocity create', which sets velocities
/// only.
void FixPolhode::warn_of_particles_at_rest() {
  if (!has_particles()) return;
  std::array<double, 2> squares{};
  for (std::size_t i = 0; i < columns_->size(); ++i) {
    const Kind& of = kinds_[columns_->bodies.part[i]];
    if (of.particle == 0 || of.molecule.top == Top::atom) continue;
    squares[0] += norm2(columns_->state.p[i]);
    squares[1] += norm2(columns_->state.ell[i]);
  }
  MPI_Allreduce(MPI_IN_PLACE, squares.data(), 2, MPI_DOUBLE, MPI_SUM, world);
  if (squares[0] > 0 && squares[1] == 0 && comm->me == 0)
    error->warning(FLERR,
                   "fix polhode: particles move, but all their angular momenta are 0, so half of "
                   "the kinetic energy is missing; set d2_{}, or equilibrate with the keyword "
                   "langevin",
                   angular_momentum_name);
}

/// A column of fix property/atom.
double** FixPolhode::particle_column(const char* name, int length) const {
  int is_double = 0, columns = 0;
  const int index = atom->find_custom(name, is_double, columns);
  if (index < 0 || is_double == 0 || columns != length)
    error->all(
        FLERR,
        "fix polhode: particles need orientations and angular momenta as atom properties; define "
        "'fix ID all property/atom d2_{} 4 d2_{} 3' before the particles are created{}",
        orientation_name, angular_momentum_name,
        atom->find_custom("attitude", is_double, columns) < 0
            ? ""
            : "; d2_attitude has been renamed to d2_orientation");
  return atom->darray[index];
}

/// Copies orientations and angular momenta to the columns of LAMMPS.
void FixPolhode::set_particle_columns() {
  if (settings_.particles.empty()) return;
  double** const orientation = particle_column(orientation_name, 4);
  double** const angular_momentum = particle_column(angular_momentum_name, 3);
  for (int i = 0; i < atom->nlocal; ++i) {
    if (body_of(i) < 0 || kind(i).particle == 0) continue;
    const auto body = static_cast<std::size_t>(body_of(i));
    const Quaternion<double> a = orientation_of_particle(kind(i), columns_->pose(body));
    orientation[i][0] = a.w;
    set(orientation[i] + 1, a.vector());
    set(angular_momentum[i], columns_->state.ell[body]);
  }
}

}  // namespace polhode::lammps
