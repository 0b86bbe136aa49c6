// SPDX-License-Identifier: MIT
// The pair loops for derivatives of forces, in double precision.
#include "pair_shapes.hpp"

namespace polhode::POLHODE_LOOPS {

void pair_derivative(const PairJob<double>& job) { derivative_of_shapes(job); }

}  // namespace polhode::POLHODE_LOOPS
