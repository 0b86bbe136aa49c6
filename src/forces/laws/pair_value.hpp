// SPDX-License-Identifier: MIT
// The result of a pair potential.
#pragma once

#include "polhode/base/real.hpp"

namespace polhode {

template <class Real>
struct PairValue {
  Real u;  ///< energy [kJ/mol]
  Real s;  ///< −u'/r [kJ/mol/nm²]
};

/// A pair value that gets the derivative of u from s: du/d(r²) = −s/2.
template <class Real>
PairValue<Real> with_derivative(const PairValue<Real>& at_r, Real r2) {
  return {with_derivative(at_r.u, constant<Real>(-0.5) * at_r.s, r2), at_r.s};
}

}  // namespace polhode
