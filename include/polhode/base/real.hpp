// SPDX-License-Identifier: MIT
// The functions and operators that physics code may require of a number type beyond + - * /,
// implemented here for double and float. Packs and dual numbers overload the same functions, so
// that each potential is written once for all number types.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace polhode {

/// The result of a comparison of Reals: bool for numbers, a lane mask for packs.
template <class Real>
struct MaskOf {
  using type = bool;
};
template <class Real>
using Mask = typename MaskOf<Real>::type;

template <class Real>
constexpr Real select(bool condition, Real if_true, Real if_false) {
  return condition ? if_true : if_false;
}

/// Whether a comparison holds in any lane; a plain number has one lane.
constexpr bool any(bool mask) { return mask; }

/// The type of constant factors of a Real. For a dual number, the constant type is the plain number
/// type, because constants have no derivative. For all other Reals, the constant type is the Real
/// type.
template <class Real>
struct ConstantOf {
  using type = Real;
};
template <class Real>
using Constant = typename ConstantOf<Real>::type;

/// A literal or a parameter of a potential, converted to a Constant for Reals of any precision.
template <class Real, class T>
constexpr Constant<Real> constant(T x) {
  using C = Constant<Real>;
  if constexpr (requires { typename C::value_type; })
    return C(static_cast<typename C::value_type>(x));
  else
    return static_cast<C>(x);
}

/// Multiply-add: sum += a b.
template <class Real>
constexpr void add_product(Real& sum, const Real& a, const Real& b) {
  sum += a * b;
}
/// Negative multiply-add: sum −= a b.
template <class Real>
constexpr void subtract_product(Real& sum, const Real& a, const Real& b) {
  sum -= a * b;
}

/// A function value at x, with the known derivative of the function. A dual number takes its slope
/// from this derivative, which is cheaper than differentiating the computation of the value.
template <class Real>
constexpr Real with_derivative(const Real& value, const Real&, const Real&) {
  return value;
}

/// The value of a number without its derivative.
template <class Real>
constexpr const Real& value_of(const Real& x) {
  return x;
}

using std::abs;
using std::exp;
using std::floor;
using std::log;
using std::max;
using std::min;
using std::sqrt;

/// The table entry at an index given as a Real; packs look up each lane separately.
template <class T>
T table_entry(const T* table, T index) {
  return table[static_cast<std::size_t>(index)];
}

/// The inverse square root 1/√a.
template <class Real>
Real inverse_sqrt(Real a) {
  return Real(1.0) / sqrt(a);
}

/// The powers 1/r, 1/r² and 1/r³, computed from r². Packs compute these powers by a faster method
/// than repeated multiplication by 1/r.
template <class Real>
class InversePowers {
 public:
  InversePowers() = default;
  explicit InversePowers(Real r2) : inverse_r_(inverse_sqrt(r2)) {}
  Real first() const { return inverse_r_; }
  Real second() const { return inverse_r_ * inverse_r_; }
  Real third() const { return inverse_r_ * inverse_r_ * inverse_r_; }

 private:
  Real inverse_r_;
};

}  // namespace polhode
