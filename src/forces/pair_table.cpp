// SPDX-License-Identifier: MIT
#include "polhode/forces/pair_table.hpp"

#include <cmath>

#include "polhode/base/error.hpp"
#include "polhode/base/units.hpp"

namespace polhode {

std::vector<Site> interacting_sites(const Molecule& molecule) {
  std::vector<Site> sites;
  for (const Site& site : molecule.sites)
    if (site.charge != 0 || site.epsilon != 0) sites.push_back(site);
  if (sites.size() > most_sites)
    throw Error("molecule '" + molecule.name + "' has " + std::to_string(sites.size()) +
                " interacting sites; at most " + std::to_string(most_sites) +
                " fit the pair loops, so join sites or split the molecule");
  return sites;
}

PairTable::PairTable(const Molecule& first, const Molecule& second) {
  const std::vector<Site> as = interacting_sites(first), bs = interacting_sites(second);
  sites_a = as.size();
  sites_b = bs.size();
  of_b.resize(sites_b);
  for (std::size_t b = 0; b < sites_b; ++b)
    for (std::size_t a = 0; a < sites_a; ++a) {
      const double charges = units::coulomb * as[a].charge * bs[b].charge;
      const double epsilon = std::sqrt(as[a].epsilon * bs[b].epsilon);
      const auto lj = LennardJones::of((as[a].sigma + bs[b].sigma) / 2, epsilon);
      if (charges != 0 || epsilon != 0)
        of_b[b].push_back({a, charges, lj, charges != 0, epsilon != 0});
    }
}

PairTables::PairTables(const Topology& topology) : parts_(topology.parts.size()) {
  for (const auto& a : topology.parts)
    for (const auto& b : topology.parts) tables_.emplace_back(a.molecule, b.molecule);
}

}  // namespace polhode
