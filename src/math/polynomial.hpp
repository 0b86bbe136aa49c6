// SPDX-License-Identifier: MIT
// Evaluates polynomials by Horner's rule, one coefficient per call, so that a loop can evaluate
// several polynomials at once.
#pragma once

#include "math/dual.hpp"

namespace polhode {

/// Evaluates a polynomial Σ cₙ yⁿ. The coefficients are supplied from the highest to the lowest.
template <class Real>
class Polynomial {
 public:
  Polynomial() = default;
  explicit Polynomial(Real highest) : sum_(highest) {}
  void step(Real y, Real c) { sum_ = sum_ * y + c; }
  /// Returns the result after the last coefficient.
  Real value(Real) const { return sum_; }

 private:
  Real sum_{};
};

/// Evaluates a polynomial of a dual number. The derivative is accumulated together with the sum by
/// Horner's rule, and finally multiplied by the slope of y.
template <class Real>
class Polynomial<Dual<Real>> {
 public:
  Polynomial() = default;
  explicit Polynomial(Real highest) : sum_(highest) {}
  void step(const Dual<Real>& y, Real c) {
    derivative_ = derivative_ * y.value + sum_;
    sum_ = sum_ * y.value + c;
  }
  Dual<Real> value(const Dual<Real>& y) const { return {sum_, derivative_ * y.slope}; }

 private:
  Real sum_{}, derivative_{};
};

}  // namespace polhode
