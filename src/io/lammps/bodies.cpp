// SPDX-License-Identifier: MIT
// The molecules of a LAMMPS data file as rigid bodies, and its atoms as a frame.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "kinds.hpp"
#include "polhode/base/error.hpp"

namespace polhode {
namespace {

// Whether the parameters of pairs of unlike types follow from a mixing rule.
bool leaves_pairs_open(const LammpsData& data) {
  std::size_t dispersive = 0;
  for (const auto& [type, t] : data.types) dispersive += !is_zero(t.epsilon, t.law);
  return data.pairs.empty() && dispersive > 1;
}

void check_forces(const LammpsData& data) {
  const std::string& style = data.pair_style;
  if (style.find("tip4p") != style.npos)
    throw Error(
        fmt::format(
            "the pair style is '{}', whose site M is not in the data file; add for example "
            "molecules = [{{ model = \"tip4p\", count = {} }}] next to this initial_configuration",
            style, data.kinds.front().count),
        data.file);
  if (style.starts_with("hybrid"))
    throw Error(
        fmt::format(
            "the pair style is '{}', and pairs of atoms with different styles are not supported; "
            "use one of mie/cut, lj/cut and buck for all pairs, or add for example molecules = [{{ "
            "model = \"spce\", count = {} }}] next to this initial_configuration",
            style, data.kinds.front().count),
        data.file);
  const auto law = law_of_pair_style(style);
  if (!law)
    throw Error(fmt::format("the pair style '{}' is not supported; use mie/cut, lj/cut or buck; "
                            "lj/cut and buck may include charges (coul/cut, debye, dsf, long, msm "
                            "or wolf); for a table write a molecule file with law = \"tabulated\"",
                            style),
                data.file);
  if (law == LammpsLaw::buckingham && leaves_pairs_open(data))
    throw Error(
        "the pair style buck has no mixing rule, and the file has no parameters for unlike types; "
        "write the file with 'write_data FILE pair ij'",
        data.file);
  for (const LammpsData::Atom& atom : data.atoms)
    if (!data.types.at(atom.type).has_pair_coefficients)
      throw Error(fmt::format("atom type {} has no short-range parameters; the section Pair Coeffs "
                              "must contain these parameters, as written by write_data",
                              atom.type),
                  data.file);
}

// Residues are renumbered in the order of their first atoms.
void sort_by_ids(const LammpsData& data, Frame& frame) {
  std::vector<std::size_t> order(data.atoms.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return data.atoms[a].id < data.atoms[b].id; });
  std::vector<Atom> atoms;
  atoms.reserve(order.size());
  std::vector<int> residues(order.size() + 1, 0);  // new residue numbers by old numbers
  int met = 0;
  for (const std::size_t k : order) {
    Atom atom = frame.atoms[k];
    int& residue = residues[static_cast<std::size_t>(atom.residue)];
    if (residue == 0) residue = ++met;
    atom.residue = residue;
    atoms.push_back(atom);
  }
  frame.atoms = std::move(atoms);
}

}  // namespace

Frame frame_of(const LammpsData& data, AtomOrder order) {
  Frame frame;
  frame.title = data.title;
  frame.box = data.box;
  frame.has_velocities = data.has_velocities;
  frame.source = data.file;
  frame.atoms.reserve(data.atoms.size());
  int residue = 0;
  for (const LammpsData::Kind& kind : data.kinds) {
    const auto first_kind = static_cast<std::uint32_t>(frame.kinds.size());
    const std::size_t size = kind.sites.size();
    for (std::size_t k = 0; k < size; ++k)
      frame.kinds.push_back(
          {kind.name, kind.sites[k], element_of(data.types.at(data.atoms[kind.first + k].type))});
    for (std::size_t k = 0; k < kind.count * size; ++k) {
      if (k % size == 0) ++residue;
      const LammpsData::Atom& atom = data.atoms[kind.first + k];
      frame.atoms.push_back(
          {first_kind + static_cast<std::uint32_t>(k % size), residue, atom.r, atom.v});
    }
  }
  if (order == AtomOrder::of_ids) sort_by_ids(data, frame);
  return frame;
}

RigidTopology rigid_topology(const LammpsData& data) {
  check_forces(data);
  RigidTopology result;
  std::vector<TypedSite> typed;
  for (const LammpsData::Kind& kind : data.kinds) {
    const Shape shape = straighten(
        mean_shape(kind.count, [&](std::size_t copy) { return shape_of(data, kind, copy); }));
    std::vector<Site> sites;
    for (std::size_t k = 0; k < kind.sites.size(); ++k) {
      const LammpsData::Atom& atom = data.atoms[kind.first + k];
      const LammpsData::AtomType& type = data.types.at(atom.type);
      sites.push_back({kind.sites[k], element_of(type), shape[k], type.mass, atom.charge,
                       type.sigma, type.epsilon, type.law});
      typed.push_back(
          {kind.name + '.' + kind.sites[k], std::to_string(atom.type), type.epsilon, type.law});
    }
    at_place(data.file, [&] {
      result.topology.parts.push_back({rigid_molecule(kind.name, std::move(sites)), kind.count});
    });
    result.origins.push_back(kind.sites.size() == 1
                                 ? "one atom"
                                 : "one rigid body per molecule id, with the mean shape");
  }
  result.mixing.pairs = overrides(typed, data.pairs);
  result.rule_is_open = true;
  result.rule_matters = leaves_pairs_open(data);
  return result;
}

}  // namespace polhode
