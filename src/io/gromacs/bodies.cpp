// SPDX-License-Identifier: MIT
// The molecules of a GROMACS topology as rigid bodies.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/suggest.hpp"
#include "polhode/base/error.hpp"
#include "polhode/io/settings/type_pairs.hpp"
#include "polhode/io/topology/topology_file.hpp"

namespace polhode {
namespace {

// Maximum number of atoms, far above the size of a rigid molecule. The pair loops support 64
// interacting sites.
constexpr std::size_t max_atoms = 256;

// The molecules of a type in the initial configuration, which must have an atom for each atom of
// the topology.
class Copies {
 public:
  Copies(const GromacsTopology& gromacs, std::size_t molecule, const Frame& start)
      : start_(start), real_(real_atoms(gromacs.molecules[molecule])) {
    std::size_t first = 0;
    for (const auto& block : gromacs.blocks) {
      const std::size_t size = gromacs.molecules[block.molecule].atoms.size();
      if (size > 0 && block.count > (start.atoms.size() - first) / size)
        throw Error(
            fmt::format(
                "the initial configuration ends after {} atoms, before the end of molecules '{}' "
                "of the topology; it must contain all atoms of all molecules",
                start.atoms.size(), gromacs.molecules[block.molecule].name),
            start.source);
      if (block.molecule == molecule)
        for (std::size_t k = 0; k < block.count; ++k) firsts_.push_back(first + k * size);
      first += block.count * size;
    }
  }
  std::size_t size() const { return firsts_.size(); }
  // The positions of the real atoms of one copy, made whole across periodic boundaries.
  Shape operator()(std::size_t k) const {
    Shape shape;
    const Vec3<double> base = start_.atoms[firsts_[k] + real_.front()].r;
    for (const std::size_t atom : real_)
      shape.push_back(start_.box.minimum_image(start_.atoms[firsts_[k] + atom].r - base));
    return shape;
  }

 private:
  const Frame& start_;
  std::vector<std::size_t> real_;  // indices within a copy
  std::vector<std::size_t> firsts_;
};

struct FoundShape {
  Shape shape;
  std::string origin;
  bool of_topology = true;  // whether the topology determines the shape
};

class Shapes {
 public:
  Shapes(const GromacsTopology& gromacs, const TopologySettings& settings, const Frame* start)
      : gromacs_(gromacs), settings_(settings), start_(start) {}

  FoundShape of(std::size_t index) const {
    const GromacsMolecule& molecule = gromacs_.molecules[index];
    const std::size_t atoms = real_atoms(molecule).size();
    const auto& rigid = settings_.rigid;
    const bool declared = std::find(rigid.begin(), rigid.end(), molecule.name) != rigid.end();
    if (atoms == 0)
      throw Error(
          fmt::format("molecule type '{}' has no atoms; it must have at least one", molecule.name),
          text_of(molecule.place));
    if (!molecule.obstacle.empty())
      throw Error(fmt::format("molecule type '{}' has a section [ {} ], but rigid bodies cannot "
                              "have one; delete the section, or use another model",
                              molecule.name, molecule.obstacle),
                  text_of(molecule.obstacle_place));
    if (atoms > max_atoms)
      throw Error(
          fmt::format("molecule type '{}' has {} atoms; a rigid molecule may have at most {}",
                      molecule.name, atoms, max_atoms),
          text_of(molecule.place));
    if (const auto given = settings_.shapes.find(molecule.name); given != settings_.shapes.end())
      return {check(given->second, molecule), "rigid, shape from the run file", false};
    if (atoms == 1) return {{Vec3<double>{}}, "one atom"};
    try {
      const auto rigidity = declared ? Rigidity::by_bonds : Rigidity::by_constraints;
      FoundShape found =
          place_atoms(index, constrained_distances(gromacs_, molecule, rigidity), atoms);
      found.origin = declared ? "declared rigid, shape from bonds and angles" : by_what(molecule);
      return found;
    } catch (const Error& e) {
      if (!e.where().empty()) throw;
      if (declared) return mean(index);
      throw refusal(molecule, e);
    }
  }

 private:
  // Checks a shape from the run file, which must agree with the settles and constraints.
  Shape check(const Shape& shape, const GromacsMolecule& molecule) const {
    const std::size_t atoms = real_atoms(molecule).size();
    if (shape.size() != atoms)
      throw Error(
          fmt::format("the shape of molecule type '{}' has {} positions; it must have {}: one "
                      "position for each atom except virtual sites, in the order of the atoms",
                      molecule.name, shape.size(), atoms),
          text_of(molecule.place));
    for (const auto& [a, b, length] :
         constrained_distances(gromacs_, molecule, Rigidity::by_constraints))
      if (const double found = norm(shape[a] - shape[b]);
          !(std::abs(found - length) <= distance_tolerance))
        throw Error(
            fmt::format(
                "in the shape of molecule type '{}' atoms {} and {} are {:.6g} nm apart, but its "
                "settles or constraints give {:.6g} nm; both distances must agree within {:g} nm",
                molecule.name, a + 1, b + 1, found, length, distance_tolerance),
            text_of(molecule.place));
    return shape;
  }

  FoundShape place_atoms(std::size_t index, const std::vector<Distance>& distances,
                         std::size_t atoms) const {
    PlacedPoints found = place_points(atoms, distances);
    if (found.dimension < 3 || start_ == nullptr) return {std::move(found.points), {}};
    // Distances do not distinguish a shape from its mirror image. The first molecule in the initial
    // configuration decides which shape is used.
    const Shape there = Copies(gromacs_, index, *start_)(0);
    Shape mirror = mirror_image(found.points);
    const bool mirrored = difference(mirror, there) < difference(found.points, there);
    return {std::move(mirrored ? mirror : found.points), {}, false};
  }

  FoundShape mean(std::size_t index) const {
    const GromacsMolecule& molecule = gromacs_.molecules[index];
    if (start_ == nullptr)
      throw Error(
          fmt::format(
              "molecule type '{}' is declared rigid, but its bonds and angles do not determine a "
              "shape; give an initial configuration that contains this molecule type",
              molecule.name),
          text_of(molecule.place));
    const Copies copies(gromacs_, index, *start_);
    Shape shape = mean_shape(copies.size(), [&](std::size_t k) { return copies(k); });
    std::vector<double> mass;
    for (const std::size_t atom : real_atoms(molecule)) mass.push_back(molecule.atoms[atom].mass);
    return {principal_shape(straighten(std::move(shape)), mass),
            "declared rigid, mean shape from the initial configuration", false};
  }

  static std::string by_what(const GromacsMolecule& molecule) {
    const bool settled = std::any_of(
        molecule.relations.begin(), molecule.relations.end(),
        [](const GromacsRelation& r) { return r.kind == GromacsRelation::Kind::settle; });
    return settled ? "rigid by settles" : "rigid by constraints";
  }

  // The reason why a molecule that was not declared rigid is flexible.
  static Error refusal(const GromacsMolecule& molecule, const Error& reason) {
    const auto moving = std::find_if(
        molecule.relations.begin(), molecule.relations.end(), [](const GromacsRelation& r) {
          return r.kind == GromacsRelation::Kind::bond || r.kind == GromacsRelation::Kind::angle;
        });
    const bool elastic = moving != molecule.relations.end();
    return Error(
        fmt::format(
            "molecule type '{0}' is not held rigid by settles or constraints: "
            "{1}{2}; declare it with rigid = [\"{0}\"] in the run file",
            molecule.name, reason.what(),
            elastic ? ", and bonds or angles of this molecule type begin at this line" : ""),
        text_of(elastic ? moving->place : molecule.place));
  }

  const GromacsTopology& gromacs_;
  const TopologySettings& settings_;
  const Frame* start_;
};

void check_names(const GromacsTopology& gromacs, const TopologySettings& settings) {
  std::vector<std::string> names;
  for (const auto& block : gromacs.blocks) names.push_back(gromacs.molecules[block.molecule].name);
  const auto require = [&](const std::string& name, const char* what) {
    if (std::find(names.begin(), names.end(), name) != names.end()) return;
    throw Error(
        fmt::format("'{}' {}, but no molecule of the topology has this name; the names are: {}",
                    name, what, join_names(names)),
        gromacs.file);
  };
  for (const std::string& name : settings.rigid) require(name, "is declared rigid");
  for (const auto& [name, shape] : settings.shapes) require(name, "has a shape");
}

// The atoms that are not virtual sites, in the principal frame.
Shape shape_of(const Molecule& molecule, const GromacsMolecule& gromacs) {
  Shape shape;
  for (const std::size_t atom : real_atoms(gromacs)) shape.push_back(molecule.sites[atom].r);
  return shape;
}

std::vector<TypedSite> typed_sites(const GromacsTopology& gromacs) {
  std::vector<TypedSite> sites;
  for (const auto& block : gromacs.blocks) {
    const GromacsMolecule& molecule = gromacs.molecules[block.molecule];
    for (const GromacsAtom& atom : molecule.atoms)
      sites.push_back({molecule.name + '.' + atom.name, atom.type,
                       gromacs.types.at(atom.type).epsilon, gromacs.types.at(atom.type).law});
  }
  return sites;
}

}  // namespace

RigidTopology rigid_topology(const GromacsTopology& gromacs, const TopologySettings& settings,
                             const Frame* start) {
  check_names(gromacs, settings);
  const Shapes shapes(gromacs, settings, start);
  std::map<std::size_t, std::pair<Molecule, std::string>> made;
  RigidTopology result;
  for (const auto& block : gromacs.blocks) {
    auto known = made.find(block.molecule);
    if (known == made.end()) {
      const GromacsMolecule& molecule = gromacs.molecules[block.molecule];
      const FoundShape found = shapes.of(block.molecule);
      const Molecule rigid = rigid_molecule(gromacs, molecule, found.shape);
      if (!found.of_topology) result.shapes.emplace(molecule.name, shape_of(rigid, molecule));
      known = made.emplace(block.molecule, std::pair{rigid, found.origin}).first;
    }
    result.topology.parts.push_back({known->second.first, block.count});
    result.origins.push_back(known->second.second);
  }
  result.mixing = {gromacs.rule, overrides(typed_sites(gromacs), gromacs.pairs)};
  return result;
}

}  // namespace polhode
