// SPDX-License-Identifier: MIT
#include "forces/constant_terms.hpp"

#include "forces/laws/laws.hpp"
#include "forces/laws/tail.hpp"
#include "forces/pairs/pair_table.hpp"
#include "polhode/base/units.hpp"

namespace polhode {

ConstantTerms constant_terms_of(const Topology& topology, const ForceSettings& s, const Box& box,
                                double tail) {
  ConstantTerms terms;
  terms.dispersion = tail / box.volume();
  double net = 0;  // sum of all charges [e]
  if (const auto smooth = smooth_polynomial(s))
    for (const auto& part : topology.parts) {
      const InteractionSites sites(part.molecule);
      const auto count = static_cast<double>(part.count);
      for (std::size_t a = 0; a < sites.charged; ++a) {
        const Site& site = sites.sites[a];
        net += count * site.charge;
        terms.self -=
            units::coulomb / 2 * count * site.charge * site.charge * smooth->smooth_at_zero();
        for (std::size_t b = a + 1; b < sites.charged; ++b)
          terms.intramolecular -= units::coulomb * count * site.charge * sites.sites[b].charge *
                                  smooth->smooth(norm(sites.sites[b].r - site.r)).u;
      }
    }
  if (s.electrostatics == Electrostatics::pme && s.mesh)
    terms.background = -units::coulomb / 2 * net * net *
                       CompactSplit(s.mesh->cutoff, s.mesh->exponent).integral() / box.volume();
  for (std::size_t d = 0; d < 3; ++d) terms.virial[d][d] = terms.dispersion + terms.background;
  return terms;
}

double tail_of(const Topology& topology, const ForceSettings& settings) {
  const bool has_tail = settings.dispersion_correction || settings.slab_dispersion;
  return has_tail ? dispersion_tail(topology, settings) : 0;
}

}  // namespace polhode
