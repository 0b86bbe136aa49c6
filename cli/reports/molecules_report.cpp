// SPDX-License-Identifier: MIT
#include "molecules_report.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "base/printable.hpp"
#include "run/listing/molecules.hpp"

namespace polhode::cli {

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

}  // namespace polhode::cli
