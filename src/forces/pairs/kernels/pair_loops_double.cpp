// SPDX-License-Identifier: MIT
// The pair loops in double precision.
#include "pair_shapes.hpp"

namespace polhode::POLHODE_LOOPS {

void pair_forces(const PairJob<double>& job) { forces_of_shapes(job); }
std::size_t pair_lanes(const PairJob<double>*) { return Pack<double>::width; }

}  // namespace polhode::POLHODE_LOOPS
