// SPDX-License-Identifier: MIT
#include "forces/laws/law_range.hpp"

#include <fmt/core.h>

#include "forces/laws/buckingham.hpp"
#include "polhode/base/error.hpp"

namespace polhode {

double inner_limit(const ShortRangeLaw& law) {
  if (const auto* buckingham = std::get_if<BuckinghamLaw>(&law))
    return Buckingham<>::inner_limit(*buckingham);
  if (const auto* tabulated = std::get_if<TabulatedLaw>(&law)) return tabulated->table->first();
  return 0;
}

std::string inner_limit_note(const Topology& topology) {
  for (const auto& part : topology.parts)
    for (const Site& site : part.molecule.sites)
      if (const double limit = inner_limit(site.law); limit > 0)
        return fmt::format(
            "; two {}.{} sites may have come closer than {:.4f} nm, the shortest distance at which "
            "their potential is valid",
            part.molecule.name, site.name, limit);
  return {};
}

void check_tables(const Topology& topology, const ForceSettings& settings) {
  const double extent = topology.extent();
  const bool by_molecule = settings.truncation == Truncation::molecule_switch;
  const double range = settings.cutoff + (by_molecule ? 2 * extent : 0);
  const auto check = [&](const ShortRangeLaw& law) {
    const auto* tabulated = std::get_if<TabulatedLaw>(&law);
    if (tabulated && tabulated->table->last() < range)
      throw Error(fmt::format(
          "table '{}' ends at {:g} nm, but sites interact up to {:g} nm{}; extend the table, or "
          "use a shorter cutoff",
          tabulated->table->name(), tabulated->table->last(), range,
          by_molecule && extent > 0 ? " (the cutoff plus the extent of two molecules)" : ""));
  };
  for (const auto& part : topology.parts)
    for (const Site& site : part.molecule.sites) check(site.law);
  for (const PairOverride& pair : settings.mixing.pairs) check(pair.law);
}

}  // namespace polhode
