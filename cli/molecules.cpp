// SPDX-License-Identifier: MIT
// polhode molecules [NAME]: lists the built-in models, or describes one model.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "polhode/base/printable.hpp"
#include "polhode/io/molecule_file.hpp"
#include "polhode/io/quantity.hpp"
#include "polhode/io/topology_file.hpp"
#include "verbs.hpp"

namespace polhode::cli {
namespace {

double in_debye(double dipole) { return dipole / unit("D", Dimension::dipole); }

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
          {"dipole", in_debye(m.dipole())},
          {"sites", sites}};
}

void print_one(const Molecule& m) {
  fmt::print(
      "{}\n  description  {}\n  mass         {:.6g} u\n  moments      {:.6g}  {:.6g}  {:.6g} u "
      "nm²\n"
      "  top          {}\n  charge       {:.6g} e\n  dipole       {:.4g} D\n  source       {}\n",
      m.name, m.description.empty() ? "-" : printable(m.description), m.mass, m.J.x, m.J.y, m.J.z,
      name(m.top), round_charge(m.charge()), in_debye(m.dipole()),
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

// The molecules that a name refers to: a model, or those of a topology file, each once.
std::vector<Molecule> find_molecules(const std::string& name) {
  if (!name.ends_with(".top") && !is_data_file(name)) return {read_molecule(name)};
  std::vector<Molecule> molecules;
  for (const auto& part : read_topology({.file = name}, nullptr).topology.parts)
    if (std::none_of(molecules.begin(), molecules.end(),
                     [&](const Molecule& m) { return m.name == part.molecule.name; }))
      molecules.push_back(part.molecule);
  return molecules;
}

void print_all() {
  std::vector<Molecule> models;
  std::size_t name_width = 0, source_width = 0;
  for (const std::string& model : molecule_names()) {
    const Molecule& m = models.emplace_back(read_molecule(model));
    name_width = std::max(name_width, m.name.size());
    source_width = std::max(source_width, m.source.size());
  }
  fmt::print("{:<{}}{:>7}{:>10}{:>7}{:>12}  {:<11} {:<{}}  {}\n", "name", name_width, "sites",
             "mass [u]", "q [e]", "dipole [D]", "top", "source", source_width, "description");
  for (const Molecule& m : models)
    fmt::print("{:<{}}{:>7}{:10.4f}{:7g}{:12.3f}  {:<11} {:<{}}  {}\n", m.name, name_width,
               m.sites.size(), m.mass, round_charge(m.charge()), in_debye(m.dipole()), name(m.top),
               m.source, source_width, m.description);
}

}  // namespace

Action molecules_verb(CLI::App& app) {
  struct Options {
    std::string name;
    bool json = false;
  };
  auto o = std::make_shared<Options>();
  app.add_option("NAME", o->name,
                 "a model's name, or the path of a molecule file, a GROMACS topology (.top) or a "
                 "LAMMPS data file; default: all");
  app.add_flag("--json", o->json, "print JSON");
  return [o] {
    if (o->json) {
      nlohmann::json list = nlohmann::json::array();
      for (const std::string& name : o->name.empty() ? molecule_names() : std::vector{o->name})
        for (const Molecule& molecule : find_molecules(name)) list.push_back(as_json(molecule));
      const bool one = !o->name.empty() && list.size() == 1;
      fmt::print("{}\n", (one ? list[0] : list).dump(2));
    } else if (o->name.empty()) {
      print_all();
    } else {
      for (const Molecule& molecule : find_molecules(o->name)) print_one(molecule);
    }
    return 0;
  };
}

}  // namespace polhode::cli
