// SPDX-License-Identifier: MIT
#include "molecules_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "polhode/base/printable.hpp"
#include "polhode/io/quantity.hpp"
#include "polhode/model/dipole.hpp"

namespace polhode::cli {
namespace {

/// The dipole moment [D], 0 where only rounding errors remain of it.
double dipole_in_debye(const Molecule& m) {
  return has_dipole(m) ? m.dipole() / unit("D", Dimension::dipole) : 0;
}

// Charges with few digits sum to zero only up to rounding.
double round_charge(double charge) { return std::abs(charge) < 1e-12 ? 0.0 : charge; }

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

void print_molecule(const Molecule& m) {
  fmt::print(
      "{}\n  description  {}\n  mass         {:.6g} u\n  moments      {:.6g}  {:.6g}  {:.6g} u "
      "nm²\n"
      "  top          {}\n  charge       {:.6g} e\n  dipole       {:.4g} D\n  source       {}\n",
      m.name, m.description.empty() ? "-" : printable(m.description), m.mass, m.J.x, m.J.y, m.J.z,
      name(m.top), round_charge(m.charge()), dipole_in_debye(m),
      m.source.empty() ? "-" : printable(m.source));
  fmt::print(
      "  sites, in the principal frame\n    {:<6}{:>11}{:>11}{:>11}{:>10}{:>11}{:>11}{:>17}\n",
      "name", "x [nm]", "y [nm]", "z [nm]", "mass [u]", "q [e]", "sigma [nm]", "epsilon [kJ/mol]");
  for (const Site& s : m.sites)
    fmt::print("    {:<6}{:11.6f}{:11.6f}{:11.6f}{:10.4f}{:11.6f}{:11.6f}{:17.6f}\n", s.name, s.r.x,
               s.r.y, s.r.z, s.mass, s.charge, s.sigma, s.epsilon);
  for (const Site& s : m.sites)
    if (!std::holds_alternative<LennardJonesLaw>(s.law))
      fmt::print("    {:<6} {}: {}\n", s.name, name(s.law),
                 printable(parameters(s.sigma, s.epsilon, s.law)));
}

void print_molecules(const std::vector<Molecule>& molecules) {
  std::size_t name_width = 0, source_width = 0;
  for (const Molecule& m : molecules) {
    name_width = std::max(name_width, m.name.size());
    source_width = std::max(source_width, m.source.size());
  }
  fmt::print("{:<{}}{:>7}{:>10}{:>7}{:>12}  {:<11} {:<{}}  {}\n", "name", name_width, "sites",
             "mass [u]", "q [e]", "dipole [D]", "top", "source", source_width, "description");
  for (const Molecule& m : molecules)
    fmt::print("{:<{}}{:>7}{:10.4f}{:7g}{:12.3f}  {:<11} {:<{}}  {}\n", m.name, name_width,
               m.sites.size(), m.mass, round_charge(m.charge()), dipole_in_debye(m), name(m.top),
               m.source, source_width, m.description);
}

std::string molecules_json(const std::vector<Molecule>& molecules, bool one) {
  nlohmann::json list = nlohmann::json::array();
  for (const Molecule& molecule : molecules) list.push_back(as_json(molecule));
  return (one ? list.at(0) : list).dump(2);
}

}  // namespace polhode::cli
