// SPDX-License-Identifier: MIT
// What another program takes: the system of the default run.
#include <cstdio>

#include "polhode/polhode.hpp"

int main() {
  const polhode::Simulation simulation(polhode::default_config());
  std::printf("%zu molecules\n", simulation.state().size());
  return simulation.state().size() == 512 ? 0 : 1;
}
