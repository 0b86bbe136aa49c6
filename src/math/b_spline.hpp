// SPDX-License-Identifier: MIT
// Cardinal B-splines, which spread a point charge over nearby grid points.
#pragma once

#include "polhode/base/real.hpp"

namespace polhode {

/// Computes the B-spline M of order p and its derivatives at u + p − 1 − j for 0 ≤ j < p. The
/// spline values are the weights of p consecutive grid points for a charge at a distance u, from 0
/// to 1, beyond a grid point. The recursion is M_k(x) = (x M_(k−1)(x) + (k − x) M_(k−1)(x − 1))/(k
/// − 1), and the derivative is M_k'(x) = M_(k−1)(x) − M_(k−1)(x − 1) [essmann1995, Eqs. 4.1 and
/// 4.2].
/// @param curvature  second derivatives, by applying the derivative formula twice; null if not
///   needed
template <int order, class Real>
inline void b_spline(Real u, Real* w, Real* slope, Real* curvature = nullptr) {
  static_assert(order >= 3);  // at least 4 for second derivatives
  w[0] = Real(1) - u;
  w[1] = u;
  for (int k = 3; k <= order; ++k) {
    if (curvature && k + 1 == order) {  // w has order − 2 weights
      const auto weight = [&](int j) { return j < 0 || j >= k - 1 ? Real(0) : w[j]; };
      for (int j = 0; j < order; ++j)
        curvature[j] = (weight(j - 2) - weight(j - 1)) - (weight(j - 1) - weight(j));
    }
    if (k == order) {
      slope[0] = -w[0];
      for (int j = 1; j < k - 1; ++j) slope[j] = w[j - 1] - w[j];
      slope[k - 1] = w[k - 2];
    }
    const Real share = constant<Real>(1.0 / (k - 1));
    const auto rising = [&](int j) { return (u + constant<Real>(k - 1 - j)) * share; };
    w[k - 1] = rising(k - 1) * w[k - 2];
    for (int j = k - 2; j > 0; --j) w[j] = rising(j) * w[j - 1] + (Real(1) - rising(j + 1)) * w[j];
    w[0] = (Real(1) - u) * share * w[0];
  }
}

}  // namespace polhode
