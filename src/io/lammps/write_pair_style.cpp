// SPDX-License-Identifier: MIT
// The force settings as commands for pair_style polhode of LAMMPS.
#include <fmt/core.h>
#include <fmt/ostream.h>

#include <cmath>
#include <ostream>

#include "forces/laws/setting_names.hpp"
#include "forces/pairs/pair_table.hpp"
#include "io/settings/quantity.hpp"
#include "io/topology/lammps_export.hpp"
#include "polhode/base/error.hpp"
#include "polhode/base/units.hpp"

namespace polhode {
namespace {

// The values of pair_coeff for each potential; empty if pair_style polhode does not have it.
template <class Other>
std::string coefficients(const Other&) {
  return {};
}

std::string depth_and_diameter(double epsilon, double sigma) {
  return fmt::format("{:.17g} {:.17g}", epsilon / unit("kcal/mol", Dimension::energy),
                     sigma / unit("A", Dimension::length));
}

std::string coefficients(const LennardJones<double>& law) {
  if (law.c12 == 0) return depth_and_diameter(0, 0);
  return depth_and_diameter(law.c6 * law.c6 / (4 * law.c12), std::pow(law.c12 / law.c6, 1.0 / 6));
}

std::string coefficients(const Mie<double>& law) {
  const double strength_of_one = Mie<double>::of(1, 1, {law.n, law.m}).strength;
  return fmt::format("mie {} {:.17g} {:.17g}",
                     depth_and_diameter(law.strength / strength_of_one, std::sqrt(law.sigma2)),
                     law.n, law.m);
}

std::string coefficients(const Buckingham<double>& law) {
  const double angstrom = unit("A", Dimension::length), kcal = unit("kcal/mol", Dimension::energy);
  return fmt::format("buckingham {:.17g} {:.17g} {:.17g}", law.A / kcal, 1 / law.B / angstrom,
                     law.c6 / kcal / std::pow(angstrom, 6));
}

}  // namespace

Molecule lone_site(const LammpsTypes::Type& type, const Topology& topology, double charge) {
  Molecule molecule;
  molecule.name = topology.parts[type.part].molecule.name;
  molecule.sites = {type.site};
  molecule.sites[0].r = {};
  molecule.sites[0].charge = charge;
  return molecule;
}

std::string lammps_pair_style(const ForceSettings& s) {
  const double angstrom = unit("A", Dimension::length);
  std::string text = fmt::format(
      "pair_style polhode {:.17g} truncation {} electrostatics {} precision {}",
      s.cutoff / angstrom, name_of(s.truncation), name_of(s.electrostatics), name_of(s.precision));
  if (s.truncation != Truncation::site_shift)
    text += fmt::format(" switch {:.17g} smoothness {}", s.switch_from / angstrom, s.smoothness);
  if (s.electrostatics == Electrostatics::reaction_field)
    text += std::isinf(s.dielectric) ? " dielectric infinite"
                                     : fmt::format(" dielectric {:.17g}", s.dielectric);
  if (s.electrostatics == Electrostatics::damped_shifted_force)
    text += fmt::format(" damping {:.17g}", s.damping * angstrom);
  return text + '\n';
}

void write_lammps_pair_coefficients(std::ostream& out, const Topology& topology,
                                    const ForceSettings& settings, const LammpsTypes& types) {
  const auto& all = types.types();
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i; j < all.size(); ++j) {
      constexpr double any =
          1;  // sites without a charge may not interact, and are then omitted from tables
      const PairTable table(lone_site(all[i], topology, any), lone_site(all[j], topology, any),
                            settings.mixing);
      const ShortRange<double>& law = table.any_law<double>().law.front();
      const std::string values =
          std::visit([](const auto& x) { return coefficients(x); }, law.law());
      if (values.empty())
        throw Error(fmt::format(
            "pair_style polhode does not have the potential of sites {} and {}; use --pair-style "
            "table",
            all[i].name, all[j].name));
      fmt::print(out, "pair_coeff {} {} {} # {} with {}\n", i + 1, j + 1, values, all[i].name,
                 all[j].name);
    }
}

double lammps_dielectric() {
  constexpr double lammps = 332.06371;  // Coulomb's constant of LAMMPS [kcal/mol Å]
  const double angstrom = unit("A", Dimension::length), kcal = unit("kcal/mol", Dimension::energy);
  return lammps / (units::coulomb / kcal / angstrom);
}

}  // namespace polhode
