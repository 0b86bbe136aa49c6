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
#include "lone_site.hpp"
#include "polhode/base/error.hpp"
#include "polhode/base/units.hpp"

namespace polhode {
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
  const double angstrom = unit("A", Dimension::length), kcal = unit("kcal/mol", Dimension::energy);
  const auto& all = types.types();
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i; j < all.size(); ++j) {
      constexpr double any =
          1;  // sites without a charge may not interact, and are then omitted from tables
      const PairTable table(lone_site(all[i], topology, any), lone_site(all[j], topology, any),
                            settings.mixing);
      const ShortRange<double>& law = table.any_law<double>().law.front();
      if (!law.is_lennard_jones())
        throw Error(
            fmt::format("the potential of sites {} and {} is not Lennard-Jones, but pair_style "
                        "polhode supports only Lennard-Jones; use --pair-style table",
                        all[i].name, all[j].name));
      const auto [c6, c12] = law.lennard_jones();
      fmt::print(out, "pair_coeff {} {} {:.17g} {:.17g} # {} with {}\n", i + 1, j + 1,
                 c12 == 0 ? 0 : c6 * c6 / (4 * c12) / kcal,
                 c12 == 0 ? 0 : std::pow(c12 / c6, 1.0 / 6) / angstrom, all[i].name, all[j].name);
    }
}

double lammps_dielectric() {
  constexpr double lammps = 332.06371;  // Coulomb's constant of LAMMPS [kcal/mol Å]
  const double angstrom = unit("A", Dimension::length), kcal = unit("kcal/mol", Dimension::energy);
  return lammps / (units::coulomb / kcal / angstrom);
}

}  // namespace polhode
