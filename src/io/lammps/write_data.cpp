// SPDX-License-Identifier: MIT
// LAMMPS data files.
#include <fmt/core.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <optional>
#include <ostream>
#include <variant>

#include "io/settings/quantity.hpp"
#include "io/topology/lammps_export.hpp"
#include "model/wrap.hpp"
#include "polhode/io/coordinates/frame.hpp"

namespace polhode {
namespace {

bool alike(const Site& a, const Site& b) {
  return a.element == b.element && a.mass == b.mass && a.charge == b.charge && a.sigma == b.sigma &&
         a.epsilon == b.epsilon && a.law == b.law;
}

void write_header(std::ostream& out, const std::string& title, const Box& box, std::size_t atoms,
                  std::size_t bonds, std::size_t types) {
  const double angstrom = unit("A", Dimension::length);
  fmt::print(out, "LAMMPS data file: {}, units = real\n\n{} atoms\n{} atom types\n", title, atoms,
             types);
  if (bonds > 0) fmt::print(out, "{} bonds\n1 bond types\n", bonds);
  for (std::size_t d = 0; d < 3; ++d)
    fmt::print(out, "{}0 {:.17g} {}lo {}hi\n", d == 0 ? "\n" : "", box.edge[d] / angstrom, "xyz"[d],
               "xyz"[d]);
}

void write_masses(std::ostream& out, const LammpsTypes& types) {
  fmt::print(out, "\nMasses\n\n");
  int number = 0;
  for (const LammpsTypes::Type& type : types.types())
    fmt::print(out, "{} {:.17g} # {}\n", ++number,
               type.site.mass > 0 ? type.site.mass : lammps_massless, type.name);
}

// A vector with enough digits to reproduce its numbers exactly.
std::string digits_of(const Vec3<double>& v) {
  return fmt::format("{:.17g} {:.17g} {:.17g}", v.x, v.y, v.z);
}

// Converts a velocity to Å/fs.
Vec3<double> in_real_units(const Vec3<double>& v) {
  return v / (unit("A", Dimension::length) / unit("fs", Dimension::time));
}

/// The exponents of a Lennard-Jones or Mie potential; empty for other potentials.
std::optional<MieLaw> exponents(const ShortRangeLaw& law) {
  if (std::holds_alternative<LennardJonesLaw>(law)) return MieLaw{};
  if (const auto* const mie = std::get_if<MieLaw>(&law)) return *mie;
  return std::nullopt;
}

/// Writes pair coefficients if the potentials of all types have the same pair style.
void write_pair_coefficients(std::ostream& out, const LammpsTypes& types) {
  const auto& all = types.types();
  bool is_mie = false;
  for (const LammpsTypes::Type& type : all) {
    if (!exponents(type.site.law)) return;
    is_mie = is_mie || std::holds_alternative<MieLaw>(type.site.law);
  }
  fmt::print(out, "\nPair Coeffs # {}\n\n", is_mie ? "mie/cut" : "lj/cut");
  int number = 0;
  for (const LammpsTypes::Type& type : all) {
    fmt::print(out, "{} {:.17g} {:.17g}", ++number,
               type.site.epsilon / unit("kcal/mol", Dimension::energy),
               type.site.sigma / unit("A", Dimension::length));
    const MieLaw law = *exponents(type.site.law);
    if (is_mie) fmt::print(out, " {:.17g} {:.17g}", law.n, law.m);
    fmt::print(out, " # {}\n", type.name);
  }
}

}  // namespace

LammpsTypes::LammpsTypes(const Topology& topology, bool share) {
  for (std::size_t part = 0; part < topology.parts.size(); ++part) {
    const Molecule& molecule = topology.parts[part].molecule;
    std::vector<int>& numbers = numbers_.emplace_back();
    for (const Site& site : molecule.sites) {
      const auto same = std::find_if(types_.begin(), types_.end(), [&](const Type& type) {
        return share && type.part == part && alike(type.site, site);
      });
      numbers.push_back(static_cast<int>(same - types_.begin()) + 1);
      if (same == types_.end()) types_.push_back({part, site, molecule.name + '.' + site.name});
    }
  }
}

void write_lammps_data(std::ostream& out, const std::string& title, const State& state,
                       const Topology& topology, const LammpsTypes& types) {
  std::size_t bonds = 0;
  for (const auto& part : topology.parts) bonds += part.count * (part.molecule.sites.size() - 1);
  const Frame frame = frame_of(state, topology);
  write_header(out, title, state.box, frame.atoms.size(), bonds, types.types().size());
  write_masses(out, types);
  write_pair_coefficients(out, types);

  // The atoms of all bodies in order, each with its topology part and site.
  const auto each_atom = [&](const auto& visit) {
    std::size_t atom = 0, molecule = 0;
    for (std::size_t part = 0; part < topology.parts.size(); ++part)
      for (std::size_t copy = 0; copy < topology.parts[part].count; ++copy, ++molecule)
        for (std::size_t k = 0; k < topology.parts[part].molecule.sites.size(); ++k, ++atom)
          visit(atom, molecule + 1, part, k);
  };
  const double angstrom = unit("A", Dimension::length);
  fmt::print(out, "\nAtoms # full\n\n");
  each_atom([&](std::size_t atom, std::size_t molecule, std::size_t part, std::size_t k) {
    fmt::print(out, "{} {} {} {:.17g} {}\n", atom + 1, molecule, types.number(part, k),
               topology.parts[part].molecule.sites[k].charge,
               digits_of(frame.atoms[atom].r / angstrom));
  });
  fmt::print(out, "\nVelocities\n\n");
  for (std::size_t atom = 0; atom < frame.atoms.size(); ++atom)
    fmt::print(out, "{} {}\n", atom + 1, digits_of(in_real_units(frame.atoms[atom].v)));
  if (bonds == 0) return;
  fmt::print(out, "\nBonds\n\n");
  std::size_t bond = 0;
  each_atom([&](std::size_t atom, std::size_t, std::size_t, std::size_t k) {
    if (k > 0) fmt::print(out, "{} 1 {} {}\n", ++bond, atom + 1 - k, atom + 1);
  });
}

void write_lammps_particles(std::ostream& out, const std::string& title, const State& state,
                            const Topology& topology, const LammpsTypes& types) {
  const Bodies bodies(topology);
  const double angstrom = unit("A", Dimension::length);
  const std::size_t sites = types.types().size();
  write_header(out, title, state.box, state.size(), 0, sites + topology.parts.size());
  write_masses(out, types);
  for (std::size_t part = 0; part < topology.parts.size(); ++part)
    fmt::print(out, "{} {:.17g} # {}\n", sites + part + 1, topology.parts[part].molecule.mass,
               topology.parts[part].molecule.name);
  fmt::print(out, "\nAtoms # atomic\n\n");
  for (std::size_t i = 0; i < state.size(); ++i)
    fmt::print(out, "{} {} {}\n", i + 1, sites + bodies.part[i] + 1,
               digits_of(wrapped(state.q[i], state.box) / angstrom));
  fmt::print(out, "\nVelocities\n\n");
  for (std::size_t i = 0; i < state.size(); ++i)
    fmt::print(out, "{} {}\n", i + 1, digits_of(in_real_units(bodies.inverse_m[i] * state.p[i])));
  fmt::print(out, "\n{}\n\n", lammps_particle_section);
  for (std::size_t i = 0; i < state.size(); ++i) {
    const Quaternion<double> a = state.orientation[i];
    fmt::print(out, "{} {:.17g} {} {}\n", i + 1, a.w, digits_of(a.vector()),
               digits_of(in_real_units(state.ell[i] / angstrom)));
  }
}

void write_lammps_molecule(std::ostream& out, const Topology& topology, std::size_t part,
                           const LammpsTypes& types) {
  const Molecule& molecule = topology.parts[part].molecule;
  fmt::print(out, "{}\n\n{} atoms\n", molecule.name, molecule.sites.size());
  const auto section = [&](const char* name, const auto& write) {
    fmt::print(out, "\n{}\n\n", name);
    for (std::size_t k = 0; k < molecule.sites.size(); ++k) {
      fmt::print(out, "{} ", k + 1);
      write(k, molecule.sites[k]);
    }
  };
  section("Coords", [&](std::size_t, const Site& site) {
    fmt::print(out, "{}\n", digits_of(site.r / unit("A", Dimension::length)));
  });
  section("Types", [&](std::size_t k, const Site& site) {
    fmt::print(out, "{} # {}\n", types.number(part, k), site.name);
  });
  section("Charges",
          [&](std::size_t, const Site& site) { fmt::print(out, "{:.17g}\n", site.charge); });
}

}  // namespace polhode
