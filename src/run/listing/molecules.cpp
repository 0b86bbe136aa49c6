// SPDX-License-Identifier: MIT
#include "run/listing/lists.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "base/printable.hpp"
#include "forces/laws/setting_names.hpp"
#include "io/settings/quantity.hpp"
#include "model/dipole.hpp"
#include "polhode/io/topology/molecule_file.hpp"
#include "polhode/io/topology/topology_file.hpp"
#include "run/quantity_lists.hpp"

namespace polhode {
namespace {

/// The dipole moment [D], or 0 if it is only round-off error.
double dipole_in_debye(const Molecule& m) {
  return has_dipole(m) ? m.dipole() / unit("D", Dimension::dipole) : 0;
}

/// A charge [e], rounded. The charges of a neutral molecule sum to zero only up to round-off; such
/// a sum is set to 0.
double round_charge(double charge) { return std::abs(charge) < 1e-12 ? 0.0 : charge; }

Quantities of_site(const Site& s) {
  const std::string law = printable(parameters(s.sigma, s.epsilon, s.law));
  const bool lennard_jones = std::holds_alternative<LennardJonesLaw>(s.law);
  return {{"name", "", s.name, "name of the site", "name"},
          {"element", "", s.element, "chemical element"},
          {"position", "[nm]", std::vector{s.r.x, s.r.y, s.r.z}, "position in the principal frame"},
          {"", "nm", s.r.x, "", "x", "", "", 6},
          {"", "nm", s.r.y, "", "y", "", "", 6},
          {"", "nm", s.r.z, "", "z", "", "", 6},
          {"mass", "[u]", s.mass, "mass", "mass", "", "", 6},
          {"charge", "[e]", s.charge, "charge", "q", "", "", 6},
          {"sigma", "[nm]", s.sigma, "diameter of the short-range potential", "sigma", "", "", 6},
          {"epsilon", "[kJ/mol]", s.epsilon, "well depth of the short-range potential", "epsilon",
           "", "", 6},
          {"law", "", name(s.law), "short-range potential"},
          {"parameters", "", parameters(s.sigma, s.epsilon, s.law),
           "parameters of the short-range potential"},
          row("law", lennard_jones ? "" : fmt::format("{}: {}", name(s.law), law))};
}

/// A molecule as a list.
/// @param alone  whether the molecule is listed separately, rather than as a row of a table
Quantities of_molecule(const Molecule& m, bool alone) {
  const auto label = [&](const char* text) { return alone ? text : ""; };
  std::vector<Quantities> sites;
  for (const Site& s : m.sites) sites.push_back(of_site(s));
  const Value mixing = m.mixing ? Value(std::string(name_of(*m.mixing))) : Value();
  return {{"name", "", m.name, "name of the model", "name"},
          {"", "", m.sites.size(), "", alone ? "" : "sites"},
          {"mass", "[u]", m.mass, "mass", "mass", "", "", 6},
          {"moments", "[u nm²]", std::vector{m.J.x, m.J.y, m.J.z}, "principal moments of inertia",
           label("moments"), "", "", 6},
          {"charge", "[e]", round_charge(m.charge()), "charge", "charge", "", "", 6},
          {"dipole", "[D]", dipole_in_debye(m), "dipole moment", "dipole"},
          {"top", "", name(m.top), "kind of top", "top"},
          {"mixing", "", mixing, "mixing rule of the model; null if its file gives none",
           label("mixing rule")},
          {"source", "", m.source, "key of the bibliography"},
          row("source", printable(m.source)),
          {"description", "", m.description, "description of the molecule"},
          row("description", printable(m.description)),
          {"sites", "", sites, "sites of the molecule", label("sites, in the principal frame")}};
}

}  // namespace

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

Quantities quantities(const Molecule& molecule) { return of_molecule(molecule, true); }

std::vector<Quantities> records(const std::vector<Molecule>& molecules) {
  std::vector<Quantities> list;
  for (const Molecule& molecule : molecules) list.push_back(of_molecule(molecule, false));
  return list;
}

}  // namespace polhode
