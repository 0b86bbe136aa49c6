// SPDX-License-Identifier: MIT
#include "forces/mesh/self_interaction.hpp"

#include "forces/pairs/pair_table.hpp"
#include "polhode/base/units.hpp"

namespace polhode {

SelfInteraction::SelfInteraction(const Topology& topology, const SmoothPolynomial& smooth) {
  for (const auto& part : topology.parts) {
    const InteractionSites sites(part.molecule);
    const auto count = static_cast<double>(part.count);
    for (std::size_t a = 0; a < sites.charged; ++a) {
      const Site& site = sites.sites[a];
      net += count * site.charge;
      self -= units::coulomb / 2 * count * site.charge * site.charge * smooth.smooth_at_zero();
      for (std::size_t b = a + 1; b < sites.charged; ++b)
        intramolecular -= units::coulomb * count * site.charge * sites.sites[b].charge *
                          smooth.smooth(norm(sites.sites[b].r - site.r)).u;
    }
  }
}

}  // namespace polhode
