// SPDX-License-Identifier: MIT
#include "kinds.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

#include "math/eigen.hpp"
#include "polhode/base/error.hpp"
#include "polhode/math/shape.hpp"

namespace polhode::lammps {
namespace {

// Tolerance for linear molecules, relative to the largest distance between atoms. Atoms are moved
// onto a common line if they deviate from it by less than this tolerance. Rounding to three
// decimals in Å causes such deviations in molecules of 1 Å and more.
constexpr double same_line = 0.002;
// Atoms count as unchanged within this tolerance, relative to the size of the molecule or to its
// largest velocity.
constexpr double unchanged = 1e-9;

std::string name_of(std::int64_t number) {
  return number > 0 ? "molecule " + std::to_string(number) : "atom " + std::to_string(-number);
}

std::string four_digits(double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", x);
  return text.data();
}

Vec3<double> over_J(const Molecule& molecule, Vec3<double> L) {
  for (std::size_t d = 0; d < 3; ++d) L[d] = molecule.J[d] > 0 ? L[d] / molecule.J[d] : 0.0;
  return L;
}

// There is no angular momentum about an axis with no moment of inertia.
Vec3<double> with_inertia(const Molecule& molecule, const Quaternion<double>& orientation,
                          const Vec3<double>& ell) {
  Vec3<double> L = to_body(orientation, ell);
  for (std::size_t d = 0; d < 3; ++d)
    if (molecule.J[d] == 0) L[d] = 0;
  return to_lab(orientation, L);
}

// straighten() has a fixed tolerance in nm, so the shape is scaled until this tolerance corresponds
// to `same_line`.
Shape straight(Shape shape) {
  double size = 0;
  for (const Vec3<double>& r : shape) size = std::max(size, norm(r - shape.front()));
  if (size == 0) return shape;
  const double scale = line_rounding / (same_line * size);
  for (Vec3<double>& r : shape) r = scale * r;
  shape = straighten(std::move(shape));
  for (Vec3<double>& r : shape) r = r / scale;
  return shape;
}

// Makes the kind with a given shape. The owner of the kind is the site nearest to the centre.
Kind kind_with_shape(const std::string& name, const Shape& shape,
                     const std::vector<double>& masses) {
  Kind kind;
  std::vector<Site> sites;
  for (std::size_t k = 0; k < shape.size(); ++k)
    sites.push_back({.name = std::to_string(k + 1), .r = shape[k], .mass = masses[k]});
  kind.molecule = rigid_molecule(name, std::move(sites));
  const std::vector<Site>& all = kind.molecule.sites;
  for (std::size_t k = 0; k < all.size(); ++k) {
    kind.extent = std::max(kind.extent, norm(all[k].r));
    if (norm2(all[k].r) < norm2(all[kind.owner].r)) kind.owner = k;
  }
  for (const Site& site : all)
    kind.span = std::max(kind.span, norm(site.r - kind.site(kind.owner)));
  return kind;
}

// Calls visit for each number of a kind whose vectors have their sizes. The order of the numbers is
// part of the format of restart files.
template <class AnyKind, class Visit>
void each_number(AnyKind& kind, const Visit& visit) {
  const auto visit_all = [&](auto&... numbers) { (visit(numbers), ...); };
  auto& m = kind.molecule;
  auto& frame = kind.frame;
  visit_all(kind.particle, kind.first, kind.owner, kind.span, kind.extent, m.mass, m.J.x, m.J.y,
            m.J.z, m.top, frame.w, frame.x, frame.y, frame.z);
  for (std::size_t k = 0; k < kind.types.size(); ++k) {
    auto& site = m.sites[k];
    visit_all(kind.types[k], site.mass, site.r.x, site.r.y, site.r.z);
    if (kind.particle != 0) visit(kind.charges[k]);
  }
}

}  // namespace

Kind kind_of(std::int64_t number, const std::vector<SiteAtom>& atoms) {
  Shape shape;
  std::vector<int> types;
  std::vector<double> masses;
  for (const SiteAtom& atom : atoms) {
    shape.push_back(atom.x - atoms.front().x);
    types.push_back(atom.type);
    masses.push_back(atom.mass);
  }
  Kind kind = kind_with_shape(name_of(number), straight(std::move(shape)), masses);
  kind.first = number;
  kind.types = std::move(types);
  return kind;
}

Kind kind_of_particles(int type, const MoleculeFile& file, const std::vector<double>& masses) {
  for (const double mass : masses)
    if (!(mass >= 0))
      throw Error("a site has a mass of " + four_digits(mass) + "; it must be 0 or more");
  Kind kind =
      kind_with_shape("particles of type " + std::to_string(type), straight(file.r), masses);
  kind.types = file.types;
  kind.charges = file.charges;
  kind.particle = type;
  kind.span = 0;
  Shape principal;
  for (const Site& site : kind.molecule.sites) principal.push_back(site.r);
  if (kind.molecule.top != Top::atom) kind.frame = best_rotation(principal, file.r, masses);
  return kind;
}

bool matches(const Kind& kind, const std::vector<SiteAtom>& atoms) {
  if (kind.particle != 0 || atoms.size() != kind.types.size()) return false;
  for (std::size_t k = 0; k < atoms.size(); ++k)
    if (atoms[k].type != kind.types[k] || atoms[k].mass != kind.molecule.sites[k].mass)
      return false;
  return true;
}

void append(std::vector<double>& numbers, const Kind& kind) {
  numbers.push_back(static_cast<double>(kind.types.size()));
  each_number(kind, [&](auto number) { numbers.push_back(static_cast<double>(number)); });
}

Kind read_kind(const double*& numbers) {
  Kind kind;
  const auto sites = static_cast<std::size_t>(*numbers++);
  kind.types.resize(sites);
  kind.charges.resize(sites);
  kind.molecule.sites.resize(sites);
  each_number(kind, [&]<class T>(T& number) { number = static_cast<T>(*numbers++); });
  if (kind.particle == 0) kind.charges.clear();
  kind.molecule.name = name_of(kind.first);
  for (std::size_t k = 0; k < sites; ++k) kind.molecule.sites[k].name = std::to_string(k + 1);
  return kind;
}

BodyRecord fitted_body(const Kind& kind, const std::vector<SiteAtom>& atoms) {
  BodyRecord body;
  const Molecule& m = kind.molecule;
  for (const SiteAtom& atom : atoms) {
    body.pose.q += atom.mass / m.mass * atom.x;
    body.p += atom.mass * atom.v;
  }
  if (m.top == Top::atom) return body;
  std::vector<Vec3<double>> own, lab;
  std::vector<double> mass;
  for (std::size_t k = 0; k < atoms.size(); ++k) {
    if (atoms[k].mass == 0) continue;
    own.push_back(kind.site(k));
    lab.push_back(atoms[k].x - body.pose.q);
    mass.push_back(atoms[k].mass);
    body.ell += atoms[k].mass * cross(lab.back(), atoms[k].v);
  }
  body.pose.orientation = best_rotation(own, lab, mass);
  body.ell = with_inertia(m, body.pose.orientation, body.ell);
  return body;
}

Vec3<double> position(const Kind& kind, std::size_t atom, const Pose& pose) {
  return pose.q + to_lab(pose.orientation, kind.atom(atom));
}

Vec3<double> velocity(const Kind& kind, std::size_t atom, const BodyRecord& body) {
  const Quaternion<double> a = body.pose.orientation;
  const Vec3<double> omega = to_lab(a, over_J(kind.molecule, to_body(a, body.ell)));
  return body.p / kind.molecule.mass + cross(omega, to_lab(a, kind.atom(atom)));
}

double rotational_energy(const Kind& kind, const BodyRecord& body) {
  const Vec3<double> L = to_body(body.pose.orientation, body.ell);
  return dot(L, over_J(kind.molecule, L)) / 2;
}

void check_shape(const Kind& kind, std::int64_t number, const std::vector<SiteAtom>& atoms,
                 const BodyRecord& body, double tolerance) {
  for (std::size_t k = 0; k < atoms.size(); ++k) {
    const double off = norm(atoms[k].x - position(kind, k, body.pose));
    if (off <= tolerance * kind.span) continue;
    throw Error(name_of(number) + ": atom " + std::to_string(atoms[k].id) + " is " +
                four_digits(off) + " from its position in the shape of " + name_of(kind.first) +
                "; it must be within " + four_digits(tolerance * kind.span) +
                " (tolerance times the span of the molecule); correct the coordinates, use other "
                "atom types for molecules of another shape, or raise the tolerance");
  }
}

BodyRecord updated_body(const Kind& kind, const std::vector<SiteAtom>& atoms,
                        const BodyRecord& before) {
  double off = 0, off_v = 0, fastest = 0;
  for (std::size_t k = 0; k < atoms.size(); ++k) {
    off = std::max(off, norm(atoms[k].x - position(kind, k, before.pose)));
    off_v = std::max(off_v, norm(atoms[k].v - velocity(kind, k, before)));
    fastest = std::max(fastest, norm(atoms[k].v));
  }
  const bool same_pose = off <= unchanged * kind.extent;
  if (same_pose && off_v <= unchanged * fastest) return before;
  BodyRecord fitted = fitted_body(kind, atoms);
  if (same_pose) fitted.pose = before.pose;
  return fitted;
}

BodyRecord body_of_particle(const Kind& kind, const Particle& particle, const BodyRecord* before,
                            std::int64_t id) {
  const double length = std::sqrt(norm2(particle.orientation));
  if (!(std::abs(length - 1) < 1e-3))
    throw Error(
        "particle " + std::to_string(id) + " has an orientation of length " + four_digits(length) +
        "; it must be a unit quaternion (w, x, y, z), so give d2_orientation a value for each "
        "particle, and define its fix property/atom after read_restart");
  const Molecule& m = kind.molecule;
  BodyRecord body;
  body.pose = {particle.x, normalized(particle.orientation) * kind.frame};
  body.p = m.mass * particle.v;
  body.ell = with_inertia(m, body.pose.orientation, particle.ell);
  if (before == nullptr) return body;
  const auto same = [](const Vec3<double>& x, const Vec3<double>& y, double scale) {
    return norm(x - y) <= unchanged * scale;
  };
  const Quaternion<double> turn = conjugate(before->pose.orientation) * body.pose.orientation;
  BodyRecord joined = *before;
  if (!same(body.pose.q, before->pose.q, kind.extent)) joined.pose.q = body.pose.q;
  if (norm(turn.vector()) > unchanged) joined.pose.orientation = body.pose.orientation;
  if (!same(body.p, before->p, norm(body.p))) joined.p = body.p;
  if (!same(body.ell, before->ell, norm(body.ell))) joined.ell = body.ell;
  return joined;
}

Quaternion<double> orientation_of_particle(const Kind& kind, const Pose& pose) {
  return pose.orientation * conjugate(kind.frame);
}

}  // namespace polhode::lammps
