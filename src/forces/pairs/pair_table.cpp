// SPDX-License-Identifier: MIT
#include "polhode/forces/pairs/pair_table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "polhode/base/error.hpp"
#include "polhode/base/units.hpp"

namespace polhode {

InteractionSites::InteractionSites(const Molecule& molecule) {
  const auto rank = [](const Site& s) { return s.epsilon == 0 ? 0 : s.charge != 0 ? 1 : 2; };
  for (const Site& site : molecule.sites) {
    if (site.charge == 0 && site.epsilon == 0) continue;
    sites.push_back(site);
    charged += site.charge != 0;
    dispersive += site.epsilon != 0;
  }
  std::stable_sort(sites.begin(), sites.end(),
                   [&](const Site& a, const Site& b) { return rank(a) < rank(b); });
  if (sites.size() > max_sites)
    throw Error(
        fmt::format("molecule '{}' has {} interacting sites; the pair loops support at most {}, so "
                    "join sites or split the molecule",
                    molecule.name, sites.size(), max_sites));
}

namespace {

LennardJones mix(const Site& a, const Site& b, MixingRule rule) {
  const double sigma =
      rule == MixingRule::geometric ? std::sqrt(a.sigma * b.sigma) : (a.sigma + b.sigma) / 2;
  return LennardJones::of(sigma, std::sqrt(a.epsilon * b.epsilon));
}

bool names(const std::string& word, const Molecule& molecule, const Site& site) {
  return word == molecule.name + '.' + site.name;
}

}  // namespace

PairTable::PairTable(const Molecule& first, const Molecule& second, const Mixing& mixing) {
  const InteractionSites a(first), b(second);
  sites_a = a.size(), charged_a = a.charged, dispersive_a = a.dispersive;
  sites_b = b.size(), charged_b = b.charged, dispersive_b = b.dispersive;
  for (const Site& at_b : b.sites)
    for (const Site& at_a : a.sites) {
      LennardJones lj = mix(at_a, at_b, mixing.rule);
      for (const PairOverride& pair : mixing.pairs)
        if ((names(pair.first, first, at_a) && names(pair.second, second, at_b)) ||
            (names(pair.second, first, at_a) && names(pair.first, second, at_b)))
          lj = LennardJones::of(pair.sigma, pair.epsilon);
      exact_.charge.push_back(units::coulomb * at_a.charge * at_b.charge);
      exact_.c6.push_back(lj.c6);
      exact_.c12.push_back(lj.c12);
    }
  rounded_.charge.assign(exact_.charge.begin(), exact_.charge.end());
  rounded_.c6.assign(exact_.c6.begin(), exact_.c6.end());
  rounded_.c12.assign(exact_.c12.begin(), exact_.c12.end());
}

PairTables::PairTables(const Topology& topology, const Mixing& mixing)
    : parts_(topology.parts.size()) {
  check(mixing, topology);
  for (const auto& a : topology.parts)
    for (const auto& b : topology.parts) tables_.emplace_back(a.molecule, b.molecule, mixing);
}

}  // namespace polhode
