// SPDX-License-Identifier: MIT
// The pair loops in mixed precision.
#include "pair_rows.hpp"

namespace polhode::POLHODE_LOOPS {

void pair_forces(const PairJob<float>& job) { pair_forces_of(job); }
std::size_t pair_lanes(const PairJob<float>*) { return Pack<float>::width; }

}  // namespace polhode::POLHODE_LOOPS
