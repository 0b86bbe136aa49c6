// SPDX-License-Identifier: MIT
// What another engine takes: molecules, their forces and a step, without files.
#include <cstdio>

#include "polhode/forces/force_field.hpp"
#include "polhode/integrate/integrator.hpp"
#include "polhode/integrate/scheme_text.hpp"

int main() {
  using namespace polhode;
  Site site;
  site.name = "Ar", site.mass = 39.948;
  site.sigma = 0.34, site.epsilon = 1;
  const Topology topology{{{rigid_molecule("argon", {site}), 2}}};
  const Bodies bodies(topology);
  State state(2, Box{{3, 3, 3}});
  state.q.set(1, {0.4, 0, 0});
  ForceField forces(topology, {Truncation::site_switch, 1.0, 0.8}, state.box, Workers::serial());
  const Scheme scheme = scheme_of("velocity-verlet");
  Integrator integrator(scheme, bodies, forces);
  const double before = integrator.load(state).potential();
  integrator.advance(state, 1e-3, 100);
  const double change = integrator.load(state).potential() - before;
  std::printf("the potential of two atoms changed by %g kJ/mol\n", change);
  return change < 0 ? 0 : 1;
}
