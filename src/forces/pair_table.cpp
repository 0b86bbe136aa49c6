// SPDX-License-Identifier: MIT
#include "polhode/forces/pair_table.hpp"

#include <fmt/core.h>

#include <cmath>

#include "polhode/base/error.hpp"
#include "polhode/base/units.hpp"

namespace polhode {

Arms::Arms(const Molecule& molecule) {
  for (const Site& site : molecule.sites)
    if (site.charge != 0) sites.push_back(site);
  charged = sites.size();
  for (const Site& site : molecule.sites)
    if (site.epsilon != 0) sites.push_back(site);
  if (sites.size() > most_arms)
    throw Error(
        fmt::format("molecule '{}' has {} charged and {} Lennard-Jones sites; at most {} together "
                    "fit the pair loops, so join sites or split the molecule",
                    molecule.name, charged, dispersive(), most_arms));
}

PairTable::PairTable(const Molecule& first, const Molecule& second) {
  const Arms a(first), b(second);
  charged_a = a.charged, charged_b = b.charged;
  dispersive_a = a.dispersive(), dispersive_b = b.dispersive();
  for (std::size_t k = 0; k < charged_b; ++k)
    for (std::size_t i = 0; i < charged_a; ++i)
      charges.push_back(units::coulomb * a.sites[i].charge * b.sites[k].charge);
  for (std::size_t k = charged_b; k < b.sites.size(); ++k)
    for (std::size_t i = charged_a; i < a.sites.size(); ++i)
      lennard_jones.push_back(LennardJones::of((a.sites[i].sigma + b.sites[k].sigma) / 2,
                                               std::sqrt(a.sites[i].epsilon * b.sites[k].epsilon)));
}

PairTables::PairTables(const Topology& topology) : parts_(topology.parts.size()) {
  for (const auto& a : topology.parts)
    for (const auto& b : topology.parts) tables_.emplace_back(a.molecule, b.molecule);
}

}  // namespace polhode
