// SPDX-License-Identifier: MIT
#include "run/listing/molecules.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/settings/quantity.hpp"
#include "model/dipole.hpp"
#include "polhode/io/topology/molecule_file.hpp"
#include "polhode/io/topology/topology_file.hpp"

namespace polhode {
namespace {

nlohmann::json as_json(const Molecule& m) {
  nlohmann::json sites = nlohmann::json::array();
  for (const Site& s : m.sites)
    sites.push_back({{"name", s.name},
                     {"element", s.element},
                     {"position", {s.r.x, s.r.y, s.r.z}},
                     {"mass", s.mass},
                     {"charge", s.charge},
                     {"sigma", s.sigma},
                     {"epsilon", s.epsilon},
                     {"law", name(s.law)},
                     {"parameters", parameters(s.sigma, s.epsilon, s.law)}});
  return {{"name", m.name},
          {"description", m.description},
          {"source", m.source},
          {"mass", m.mass},
          {"moments", {m.J.x, m.J.y, m.J.z}},
          {"top", name(m.top)},
          {"charge", round_charge(m.charge())},
          {"dipole", dipole_in_debye(m)},
          {"sites", sites}};
}

}  // namespace

double dipole_in_debye(const Molecule& m) {
  return has_dipole(m) ? m.dipole() / unit("D", Dimension::dipole) : 0;
}

double round_charge(double charge) { return std::abs(charge) < 1e-12 ? 0.0 : charge; }

std::vector<Molecule> find_molecules(const std::string& name) {
  std::vector<Molecule> molecules;
  if (name.empty())
    for (const std::string& model : molecule_names()) molecules.push_back(read_molecule(model));
  if (name.empty()) return molecules;
  if (!name.ends_with(".top") && !is_data_file(name)) return {read_molecule(name)};
  for (const auto& part : read_topology({.file = name}, nullptr).topology.parts)
    if (std::none_of(molecules.begin(), molecules.end(),
                     [&](const Molecule& m) { return m.name == part.molecule.name; }))
      molecules.push_back(part.molecule);
  return molecules;
}

std::string molecules_json(const std::vector<Molecule>& molecules, bool one) {
  nlohmann::json list = nlohmann::json::array();
  for (const Molecule& molecule : molecules) list.push_back(as_json(molecule));
  return (one ? list.at(0) : list).dump(2);
}

}  // namespace polhode
