// SPDX-License-Identifier: MIT
// Polynomials by Horner's rule, one coefficient at a time, so that a loop may take several of them
// in step.
#pragma once

#include "polhode/math/dual.hpp"

namespace polhode {

/// Σ cₙ yⁿ, its coefficients given from the highest down.
template <class Real>
class Polynomial {
 public:
  Polynomial() = default;
  explicit Polynomial(Real highest) : sum_(highest) {}
  void step(Real y, Real c) { sum_ = sum_ * y + c; }
  /// After the last coefficient.
  Real value(Real) const { return sum_; }

 private:
  Real sum_{};
};

/// The derivative grows beside the sum by the same rule; the slope of y multiplies it once, at the
/// end.
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
