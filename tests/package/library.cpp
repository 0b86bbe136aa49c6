// SPDX-License-Identifier: MIT
// What another program takes: the system of the default run.
#include <cstdio>

#include "polhode/base/instruction_set.hpp"
#include "polhode/run/simulation/system.hpp"

int main() {
  const polhode::System system = polhode::build_system(polhode::default_config());
  std::printf("%zu molecules, %s\n", system.state.size(),
              polhode::name(polhode::current_instruction_set()));
  return system.state.size() == 512 ? 0 : 1;
}
