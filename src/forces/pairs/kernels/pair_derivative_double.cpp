// SPDX-License-Identifier: MIT
// The derivative of the pair loops, in double precision.
#include "pair_rows.hpp"

namespace polhode::POLHODE_LOOPS {

void pair_derivative(const PairJob<double>& job) { pair_derivative_of(job); }

}  // namespace polhode::POLHODE_LOOPS
