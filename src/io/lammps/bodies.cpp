// SPDX-License-Identifier: MIT
// The molecules of a LAMMPS data file as rigid bodies, and its atoms as a frame.
#include <fmt/core.h>

#include "kinds.hpp"
#include "polhode/base/error.hpp"
#include "polhode/model/elements.hpp"

namespace polhode {
namespace {

void check_forces(const LammpsData& data) {
  const std::string& style = data.pair_style;
  if (style.find("tip4p") != style.npos)
    throw Error(
        fmt::format("the pair style is '{}', whose site M stands in no data file; write for "
                    "example molecules = [{{ model = \"tip4p\", count = {} }}] beside this "
                    "start",
                    style, data.kinds.front().count),
        data.file);
  if (!style.empty() && !style.starts_with("lj/cut"))
    throw Error(
        fmt::format("the pair style is '{}'; it must be lj/cut, with whatever Coulomb part: "
                    "other potentials are not there",
                    style),
        data.file);
  for (const LammpsData::Atom& atom : data.atoms)
    if (!data.types.at(atom.type).has_pair_coefficients)
      throw Error(
          fmt::format("atom type {} has no Lennard-Jones parameters; the section Pair Coeffs "
                      "must have them, as write_data puts them there",
                      atom.type),
          data.file);
}

// Whether the parameters of two types that differ are left to a rule.
bool leaves_pairs_open(const LammpsData& data) {
  std::size_t dispersive = 0;
  for (const auto& [type, t] : data.types) dispersive += t.epsilon > 0;
  return data.pairs.empty() && dispersive > 1;
}

}  // namespace

Frame frame_of(const LammpsData& data) {
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
      frame.kinds.push_back({kind.name, kind.sites[k],
                             element_of_mass(data.types.at(data.atoms[kind.first + k].type).mass)});
    for (std::size_t k = 0; k < kind.count * size; ++k) {
      if (k % size == 0) ++residue;
      const LammpsData::Atom& atom = data.atoms[kind.first + k];
      frame.atoms.push_back(
          {first_kind + static_cast<std::uint32_t>(k % size), residue, atom.r, atom.v});
    }
  }
  return frame;
}

RigidTopology rigid_topology(const LammpsData& data) {
  check_forces(data);
  RigidTopology result;
  std::vector<TypedSite> typed;
  for (const LammpsData::Kind& kind : data.kinds) {
    const Shape shape = straightened(
        mean_shape(kind.count, [&](std::size_t copy) { return shape_of(data, kind, copy); }));
    std::vector<Site> sites;
    for (std::size_t k = 0; k < kind.sites.size(); ++k) {
      const LammpsData::Atom& atom = data.atoms[kind.first + k];
      const LammpsData::AtomType& type = data.types.at(atom.type);
      sites.push_back({kind.sites[k], element_of_mass(type.mass), shape[k], type.mass, atom.charge,
                       type.sigma, type.epsilon});
      typed.push_back({kind.name + '.' + kind.sites[k], std::to_string(atom.type), type.epsilon});
    }
    try {
      result.topology.parts.push_back({rigid_molecule(kind.name, std::move(sites)), kind.count});
    } catch (const Error& e) {
      throw e.at(data.file);
    }
    result.origins.push_back(kind.sites.size() == 1 ? "one atom"
                                                    : "a body for each molecule id, mean shape");
  }
  result.mixing.pairs = overrides(typed, data.pairs);
  result.rule_is_open = true;
  result.rule_matters = leaves_pairs_open(data);
  return result;
}

}  // namespace polhode
