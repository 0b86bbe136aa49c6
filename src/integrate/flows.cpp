// SPDX-License-Identifier: MIT
#include "polhode/integrate/flows.hpp"

#include "polhode/base/target.hpp"

namespace polhode {

POLHODE_DECLARE_LOOPS(void drift(State&, const Bodies&, double);
                      void kick(State&, const Load&, double);)

void drift(State& state, const Bodies& bodies, double t) {
  POLHODE_CURRENT_LOOPS(drift)(state, bodies, t);
}

void kick(State& state, const Load& load, double t) { POLHODE_CURRENT_LOOPS(kick)(state, load, t); }

}  // namespace polhode
