// SPDX-License-Identifier: MIT
// The measured order of a scheme, compared with the declared order.
#pragma once

#include "measure/order.hpp"
#include "polhode/io/settings/nested_scheme_text.hpp"
#include "polhode/run/quantities.hpp"

namespace polhode {

struct Verification {
  NestedScheme scheme;
  OrderMeasurement measured;
  int declared = 0;  ///< order with which the measured order is compared; 0 if none is known

  /// Whether the measured order agrees with the declared order of the scheme. The error of a
  /// symmetric scheme is C hᵏ + O(hᵏ⁺²), so the measured order differs from k by O(h²), which is
  /// less than 0.1 here.
  bool holds() const;
};

/// Measures the order of a scheme.
/// @param order   expected order; 0 for the order in the table
/// @param lambda  displacement factor λ of finite-difference gradients
Verification verify(const NamedScheme& scheme, int order = 0, double lambda = 1e-4);

/// Checks the option for lambda.
/// @throws Error  if lambda has no effect on the scheme
void check_lambda(const NestedScheme& scheme);

/// The results of a verification as a list, from which text, JSON and the manual are made.
Quantities quantities(const Verification& verification);

}  // namespace polhode
