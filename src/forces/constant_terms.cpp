// SPDX-License-Identifier: MIT
#include "forces/constant_terms.hpp"

#include "forces/laws/laws.hpp"
#include "forces/laws/tail.hpp"
#include "forces/mesh/particle_mesh.hpp"
#include "forces/mesh/self_interaction.hpp"

namespace polhode {

ConstantTerms constant_terms_of(const Topology& topology, const ForceSettings& s, const Box& box,
                                double tail) {
  ConstantTerms terms;
  terms.dispersion = tail / box.volume();
  for (std::size_t d = 0; d < 3; ++d) terms.virial[d][d] = terms.dispersion;
  if (s.electrostatics == Electrostatics::pme) {
    const MeshConstant mesh(topology, {s.mesh->cutoff, s.mesh->exponent}, box);
    terms.self = mesh.self;
    terms.intramolecular = mesh.intramolecular;
    terms.background = mesh.background;
    for (std::size_t d = 0; d < 3; ++d) terms.virial[d] += mesh.virial[d];
  } else if (const auto smooth = smooth_polynomial(s)) {
    const SelfInteraction own(topology, *smooth);
    terms.self = own.self;
    terms.intramolecular = own.intramolecular;
  }
  return terms;
}

double tail_of(const Topology& topology, const ForceSettings& settings) {
  const bool has_tail = settings.dispersion_correction || settings.slab_dispersion;
  return has_tail ? dispersion_tail(topology, settings) : 0;
}

}  // namespace polhode
