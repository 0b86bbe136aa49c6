// SPDX-License-Identifier: MIT
// The pair loops in mixed precision.
#include "pair_shapes.hpp"

namespace polhode::POLHODE_LOOPS {

void pair_forces(const PairJob<float>& job) { forces_of_shapes(job); }
std::size_t pair_lanes(const PairJob<float>*) { return Pack<float>::width; }

}  // namespace polhode::POLHODE_LOOPS
