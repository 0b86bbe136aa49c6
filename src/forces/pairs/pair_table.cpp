// SPDX-License-Identifier: MIT
#include "forces/pairs/pair_table.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "polhode/base/error.hpp"
#include "polhode/base/units.hpp"

namespace polhode {

InteractionSites::InteractionSites(const Molecule& molecule) {
  const auto rank = [](const Site& s) { return !s.has_short_range() ? 0 : s.charge != 0 ? 1 : 2; };
  for (const Site& site : molecule.sites) {
    if (site.charge == 0 && !site.has_short_range()) continue;
    sites.push_back(site);
    charged += site.charge != 0;
    dispersive += site.has_short_range();
  }
  std::stable_sort(sites.begin(), sites.end(),
                   [&](const Site& a, const Site& b) { return rank(a) < rank(b); });
  if (sites.size() > max_sites)
    throw Error(
        fmt::format("molecule '{}' has {} interacting sites; the maximum is {}, so join sites or "
                    "split the molecule",
                    molecule.name, sites.size(), max_sites));
}

PairTable::PairTable(const Molecule& first, const Molecule& second, const Mixing& mixing) {
  const InteractionSites a(first), b(second);
  sites_a = a.size(), charged_a = a.charged, dispersive_a = a.dispersive;
  sites_b = b.size(), charged_b = b.charged, dispersive_b = b.dispersive;
  const auto names = [](const std::string& word, const Molecule& molecule, const Site& site) {
    return word == molecule.name + '.' + site.name;
  };
  const auto law_of = [&](const Site& at_a, const Site& at_b) {
    for (const PairOverride& pair : mixing.pairs)
      if ((names(pair.first, first, at_a) && names(pair.second, second, at_b)) ||
          (names(pair.second, first, at_a) && names(pair.first, second, at_b)))
        return short_range(pair.sigma, pair.epsilon, pair.law);
    return mix(at_a, at_b, mixing.rule);
  };
  auto& [lennard_jones, lennard_jones_float, any, any_float] = strengths_;
  for (const Site& at_b : b.sites)
    for (const Site& at_a : a.sites) {
      any.charge.push_back(units::coulomb * at_a.charge * at_b.charge);
      any.law.push_back(law_of(at_a, at_b).scaled_by(at_a.size * at_b.size));
      any_float.law.push_back(any.law.back().rounded());
    }
  any_float.charge.assign(any.charge.begin(), any.charge.end());
  lennard_jones.charge = any.charge;
  lennard_jones_float.charge = any_float.charge;
  if (!std::all_of(any.law.begin(), any.law.end(),
                   [](const auto& law) { return law.is_lennard_jones(); }))
    return;
  for (const ShortRange<double>& law : any.law) {
    lennard_jones.law.push_back(law.lennard_jones());
    lennard_jones_float.law.push_back(law.lennard_jones().rounded());
  }
}

PairTables::PairTables(const Topology& topology, const Mixing& mixing)
    : parts_(topology.parts.size()) {
  check(mixing, topology);
  for (const auto& a : topology.parts)
    for (const auto& b : topology.parts) tables_.emplace_back(a.molecule, b.molecule, mixing);
}

}  // namespace polhode
