// SPDX-License-Identifier: MIT
// The pair loops for derivatives of forces, in mixed precision.
#include "pair_shapes.hpp"

namespace polhode::POLHODE_LOOPS {

void pair_derivative(const PairJob<float>& job) { derivative_of_shapes(job); }

}  // namespace polhode::POLHODE_LOOPS
