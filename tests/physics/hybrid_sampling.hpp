// SPDX-License-Identifier: MIT
// The loop of hybrid Monte Carlo, for tests of what it samples.
#pragma once

#include <cstdint>

#include "polhode/ensemble/hybrid_monte_carlo.hpp"
#include "polhode/integrate/integrator.hpp"

namespace polhode {

/// What is sampled: trajectories of this many steps of length h [ps].
struct HybridSampling {
  double h;
  std::uint64_t steps, trajectories;
};

/// Performs trajectories; `sample` gets the state and its load after each, accepted or not.
template <class Integrator, class Sample>
void sample_hybrid(HybridMonteCarlo& hybrid, Integrator& integrator, State& state,
                   const HybridSampling& run, const Sample& sample) {
  for (std::uint64_t n = 0; n < run.trajectories; ++n) {
    Load load = integrator.load(state);
    hybrid.begin(state, load, run.steps * n);
    integrator.advance(state, run.h, run.steps);
    load = integrator.load(state);
    if (!hybrid.end(state, load, run.steps * (n + 1))) integrator.replace_load(load);
    sample(state, load);
  }
}

}  // namespace polhode
