// SPDX-License-Identifier: MIT
// Converts a GROMACS molecule type to a rigid molecule.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "bonded_key.hpp"
#include "model/elements.hpp"
#include "model/molecule_in_frame.hpp"
#include "polhode/base/error.hpp"
#include "polhode/base/units.hpp"
#include "polhode/io/topology/gromacs.hpp"

namespace polhode {
namespace {

using Kind = GromacsRelation::Kind;
using Place = Vec3<double>;

bool is_virtual(const GromacsRelation& r) {
  return r.kind == Kind::virtual2 || r.kind == Kind::virtual3;
}

[[noreturn]] void refuse(const std::string& what, const TextPlace& place) {
  throw Error(what, text_of(place));
}

// The parameters of an interaction, given explicitly or by the table for its atom types.
std::optional<double> first_number(const GromacsTopology& topology, const GromacsMolecule& molecule,
                                   const GromacsRelation& r,
                                   const std::map<std::string, double>& table) {
  if (r.given > 0) return r.numbers[0];
  std::vector<std::string> types;
  const std::size_t count = r.kind == Kind::angle ? 3 : 2;
  for (std::size_t k = 0; k < count; ++k)
    types.push_back(topology.types.at(molecule.atoms[r.atoms[k]].type).bonded);
  const auto found = table.find(gromacs::bonded_key(types));
  if (found == table.end()) return std::nullopt;
  return found->second;
}

// Function types whose first parameter is the equilibrium length or angle. For bonds, the function
// types with an equilibrium length are harmonic, fourth power, Morse and cubic. For angles, the
// function types with an equilibrium angle are harmonic, cosine, Urey-Bradley, quartic and
// restricted.
bool has_minimum(const GromacsRelation& r) {
  constexpr std::array bonds = {1, 2, 3, 4, 6}, angles = {1, 2, 5, 6, 10};
  const auto& known = r.kind == Kind::bond ? bonds : angles;
  return std::find(known.begin(), known.end(), r.function) != known.end();
}

class Distances {
 public:
  explicit Distances(const GromacsMolecule& molecule) : index_(molecule.atoms.size(), none) {
    const auto real = real_atoms(molecule);
    for (std::size_t k = 0; k < real.size(); ++k) index_[real[k]] = k;
  }
  void add(std::size_t a, std::size_t b, double length, const GromacsRelation& r) {
    if (index_[a] == none || index_[b] == none || a == b)
      refuse(fmt::format("atoms {} and {} are constrained; a constraint must be between two "
                         "different atoms and not between virtual sites",
                         a + 1, b + 1),
             r.place);
    if (!(length > 0))
      refuse(fmt::format("the length of the constraint is {} nm; it must be above 0 nm", length),
             r.place);
    list.push_back({index_[a], index_[b], length});
    first_.try_emplace(std::minmax(index_[a], index_[b]), length);
  }
  // The distance between two atoms, if known.
  std::optional<double> between(std::size_t a, std::size_t b) const {
    const auto found = first_.find(std::minmax(index_[a], index_[b]));
    if (found == first_.end()) return std::nullopt;
    return found->second;
  }
  std::vector<Distance> list;

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> index_;  // index of each atom among the real atoms
  std::map<std::pair<std::size_t, std::size_t>, double> first_;  // for each pair of atoms, the
                                                                 // distance in the first entry of
                                                                 // the list
};

// The position of a virtual site, from the positions of its constructing atoms (GROMACS reference
// manual, "Virtual interaction sites").
Place build_virtual_site(const GromacsRelation& r, std::span<const Place> places) {
  const Place ri = places[r.atoms[1]], ij = places[r.atoms[2]] - ri;
  const auto& [a, b, c] = r.numbers;
  if (r.kind == Kind::virtual2) {
    if (r.function == 1) return ri + a * ij;
    if (r.function == 2) return ri + a / norm(ij) * ij;
  } else {
    const Place ik = places[r.atoms[3]] - ri, jk = ik - ij;
    if (r.function == 1) return ri + a * ij + b * ik;
    if (r.function == 2) {
      const Place towards = ij + a * jk;
      return ri + b / norm(towards) * towards;
    }
    if (r.function == 3) {
      const Place up = jk - dot(ij, jk) / norm2(ij) * ij;
      const double theta = a * units::pi / 180;
      return ri + b * std::cos(theta) / norm(ij) * ij + b * std::sin(theta) / norm(up) * up;
    }
    if (r.function == 4) return ri + a * ij + b * ik + c * cross(ij, ik);
  }
  refuse(fmt::format("the function type of this virtual site is {}; the supported types are {}",
                     r.function, r.kind == Kind::virtual2 ? "1 and 2" : "1, 2, 3 and 4"),
         r.place);
}

}  // namespace

std::vector<std::size_t> real_atoms(const GromacsMolecule& molecule) {
  std::vector<bool> real(molecule.atoms.size(), true);
  for (const GromacsRelation& r : molecule.relations)
    if (is_virtual(r)) real[r.atoms[0]] = false;
  std::vector<std::size_t> indices;
  for (std::size_t k = 0; k < real.size(); ++k)
    if (real[k]) indices.push_back(k);
  return indices;
}

std::vector<Distance> constrained_distances(const GromacsTopology& topology,
                                            const GromacsMolecule& molecule, Rigidity rigidity) {
  Distances distances(molecule);
  const auto& tables = topology.equilibrium;
  for (const GromacsRelation& r : molecule.relations) {
    if (r.kind == Kind::settle) {
      const std::size_t o = r.atoms[0];
      distances.add(o, o + 1, r.numbers[0], r);
      distances.add(o, o + 2, r.numbers[0], r);
      distances.add(o + 1, o + 2, r.numbers[1], r);
    } else if (r.kind == Kind::constraint) {
      auto length = first_number(topology, molecule, r, tables.constraints);
      if (!length) length = first_number(topology, molecule, r, tables.bonds);
      if (!length)
        refuse(fmt::format(
                   "the constraint of atoms {} and {} has no length, here or in [ constrainttypes "
                   "] or [ bondtypes ]; write the length after the function type",
                   r.atoms[0] + 1, r.atoms[1] + 1),
               r.place);
      distances.add(r.atoms[0], r.atoms[1], *length, r);
    } else if (r.kind == Kind::bond && rigidity == Rigidity::by_bonds && has_minimum(r)) {
      if (const auto length = first_number(topology, molecule, r, tables.bonds))
        distances.add(r.atoms[0], r.atoms[1], *length, r);
    }
  }
  if (rigidity == Rigidity::by_constraints) return std::move(distances.list);
  for (const GromacsRelation& r : molecule.relations) {  // bond, angle, bond: a triangle
    if (r.kind != Kind::angle || !has_minimum(r)) continue;
    const auto angle = first_number(topology, molecule, r, tables.angles);
    const auto a = distances.between(r.atoms[0], r.atoms[1]);
    const auto b = distances.between(r.atoms[1], r.atoms[2]);
    if (!angle || !a || !b || distances.between(r.atoms[0], r.atoms[2])) continue;
    const double cosine = std::cos(*angle * units::pi / 180);
    distances.add(r.atoms[0], r.atoms[2], std::sqrt(*a * *a + *b * *b - 2 * *a * *b * cosine), r);
  }
  return std::move(distances.list);
}

Molecule rigid_molecule(const GromacsTopology& topology, const GromacsMolecule& molecule,
                        const Shape& shape) {
  std::vector<Place> places(molecule.atoms.size());
  std::vector<bool> known(molecule.atoms.size(), false);
  const auto real = real_atoms(molecule);
  for (std::size_t k = 0; k < real.size(); ++k) places[real[k]] = shape[k], known[real[k]] = true;
  for (const GromacsRelation& r : molecule.relations) {
    if (!is_virtual(r)) continue;
    if (known[r.atoms[0]])
      refuse(fmt::format("virtual site {} is defined twice; delete one of the definitions",
                         r.atoms[0] + 1),
             r.place);
    for (std::size_t k = 1; k < (r.kind == Kind::virtual2 ? 3 : 4); ++k)
      if (!known[r.atoms[k]])
        refuse(
            fmt::format(
                "virtual site {} is constructed from atom {}, which has no position yet; a virtual "
                "site must be constructed from atoms, or from virtual sites of earlier lines",
                r.atoms[0] + 1, r.atoms[k] + 1),
            r.place);
    const GromacsAtom& site = molecule.atoms[r.atoms[0]];
    if (site.mass != 0)
      refuse(fmt::format("virtual site '{}' has a mass of {} u; it must be 0 u, since the site is "
                         "constructed from atoms",
                         site.name, site.mass),
             site.place);
    const Place r0 = build_virtual_site(r, places);
    if (!std::isfinite(norm2(r0)))
      refuse(fmt::format("virtual site {} has no position: the atoms from which it is constructed "
                         "are on a line or coincide; choose other atoms",
                         r.atoms[0] + 1),
             r.place);
    places[r.atoms[0]] = r0;
    known[r.atoms[0]] = true;
  }
  std::vector<Site> sites;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const GromacsAtom& atom = molecule.atoms[k];
    const GromacsAtomType& type = topology.types.at(atom.type);
    if (type.one_sided)
      refuse(fmt::format("atom type '{}' has only one of C6 and C12; set both or neither, since "
                         "sigma and epsilon follow from both",
                         type.name),
             type.place);
    std::string element;
    if (atom.mass > 0) element = element_of_number(type.atomic_number);
    if (atom.mass > 0 && element.empty()) element = element_of_mass(atom.mass);
    sites.push_back({atom.name, element, places[k], atom.mass, atom.charge, type.sigma,
                     type.epsilon, type.law});
  }
  return at_place(text_of(molecule.place),
                  [&] { return molecule_in_frame(molecule.name, std::move(sites)); });
}

}  // namespace polhode
