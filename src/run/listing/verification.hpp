// SPDX-License-Identifier: MIT
// The order of a scheme, measured and compared with the declared one.
#pragma once

#include "measure/order.hpp"
#include "polhode/io/settings/nested_scheme_text.hpp"
#include "polhode/run/quantities.hpp"

namespace polhode {

struct Verification {
  NestedScheme scheme;
  OrderMeasurement measured;
  int declared = 0;  ///< order to compare with; 0: none is known

  /// The error of a symmetric scheme is C hᵏ + O(hᵏ⁺²): the slope differs from k by O(h²), here
  /// less than 0.1.
  bool holds() const;
};

/// @param order   expected order; 0: that of the table
/// @param lambda  of finite-difference gradients
Verification verify(const NamedScheme& scheme, int order = 0, double lambda = 1e-4);

/// @throws Error  if lambda has no effect on the scheme
void check_lambda(const NestedScheme& scheme);

/// The results as a list, from which text, JSON and the manual follow.
Quantities quantities(const Verification& verification);

}  // namespace polhode
