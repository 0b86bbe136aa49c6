// SPDX-License-Identifier: MIT
// Dual numbers a + b ε with ε² = 0. A formula evaluated with dual numbers yields the value and the
// derivative along a direction, both exact to rounding. Dual numbers of packs differentiate the
// pair loops. Constants are multiplied as plain numbers, and unused values are not computed. Sums
// of products and powers of distances have separate short formulas. The computing time is close to
// the cost of a hand-written derivative.
#pragma once

#include <type_traits>

#include "polhode/base/vec3.hpp"

namespace polhode {

/// A dual number: a value and its derivative.
/// @tparam Real  a number or a pack
template <class Real>
struct Dual {
  Real value{};
  Real slope{};  ///< derivative along the chosen direction

  constexpr Dual() = default;
  constexpr Dual(Real v, Real s = Real(0))
      : value(v), slope(s) {}  // implicit, because conversions to a Real
                               // are implicit

  friend constexpr Dual operator+(Dual a, Dual b) { return {a.value + b.value, a.slope + b.slope}; }
  friend constexpr Dual operator-(Dual a, Dual b) { return {a.value - b.value, a.slope - b.slope}; }
  friend constexpr Dual operator-(Dual a) { return {-a.value, -a.slope}; }
  friend constexpr Dual operator*(Dual a, Dual b) {
    return {a.value * b.value, a.slope * b.value + a.value * b.slope};
  }
  friend constexpr Dual operator/(Dual a, Dual b) {
    const Real quotient = a.value / b.value;
    return {quotient, (a.slope - quotient * b.slope) / b.value};
  }
  constexpr Dual& operator+=(Dual b) { return *this = *this + b; }
  constexpr Dual& operator-=(Dual b) { return *this = *this - b; }

  // Operations with constants follow.
  friend constexpr Dual operator+(Dual a, Real c) { return {a.value + c, a.slope}; }
  friend constexpr Dual operator+(Real c, Dual a) { return {c + a.value, a.slope}; }
  friend constexpr Dual operator-(Dual a, Real c) { return {a.value - c, a.slope}; }
  friend constexpr Dual operator-(Real c, Dual a) { return {c - a.value, -a.slope}; }
  friend constexpr Dual operator*(Dual a, Real c) { return {a.value * c, a.slope * c}; }
  friend constexpr Dual operator*(Real c, Dual a) { return {c * a.value, c * a.slope}; }
  friend constexpr Dual operator/(Dual a, Real c) { return {a.value / c, a.slope / c}; }
  friend constexpr Dual operator/(Real c, Dual a) { return Dual(c) / a; }

  friend constexpr auto operator<(Dual a, Dual b) { return a.value < b.value; }
  friend constexpr auto operator>(Dual a, Dual b) { return a.value > b.value; }

  friend Dual sqrt(Dual a) {
    const Real root = sqrt(a.value);
    return {root, a.slope / (root + root)};
  }
  friend Dual exp(Dual a) {
    const Real power = exp(a.value);
    return {power, power * a.slope};
  }
  friend Dual log(Dual a) { return {log(a.value), a.slope / a.value}; }
  /// The floor, a step function whose derivative is 0 except at the steps.
  friend Dual floor(Dual a) { return floor(a.value); }
};

template <class Real>
inline constexpr bool is_dual = false;
template <class Real>
inline constexpr bool is_dual<Dual<Real>> = true;

template <class Real>
constexpr const Real& value_of(const Dual<Real>& x) {
  return x.value;
}

template <class Real>
struct ConstantOf<Dual<Real>> {
  using type = Real;
};
template <class Real>
struct MaskOf<Dual<Real>> : MaskOf<Real> {};

template <class Real>
requires(!std::is_same_v<Mask<Real>, bool>)  // plain numbers use the general overload
    Dual<Real> select(Mask<Real> mask, Dual<Real> if_true, Dual<Real> if_false) {
  return {select(mask, if_true.value, if_false.value), select(mask, if_true.slope, if_false.slope)};
}

// With a constant bound, the derivative is 0 where the result is the bound.
template <class Real>
constexpr Dual<Real> min(const Dual<Real>& a, const Real& bound) {
  return {min(a.value, bound), select(a.value < bound, a.slope, Real(0))};
}
template <class Real>
constexpr Dual<Real> max(const Dual<Real>& a, const Real& bound) {
  return {max(a.value, bound), select(a.value > bound, a.slope, Real(0))};
}

// These formulas are sums of single products, each of which compiles to a multiply-add.
template <class Real>
constexpr void add_product(Dual<Real>& sum, const Dual<Real>& a, const Dual<Real>& b) {
  sum.value += a.value * b.value;
  sum.slope += a.slope * b.value;
  sum.slope += a.value * b.slope;
}
template <class Real>
constexpr void subtract_product(Dual<Real>& sum, const Dual<Real>& a, const Dual<Real>& b) {
  sum.value -= a.value * b.value;
  sum.slope -= a.slope * b.value;
  sum.slope -= a.value * b.slope;
}

template <class Real>
constexpr Dual<Real> with_derivative(const Dual<Real>& value, const Dual<Real>& derivative,
                                     const Dual<Real>& x) {
  return {value.value, derivative.value * x.slope};
}

template <class Real>
constexpr Vec3<Real> value(const Vec3<Dual<Real>>& v) {
  return {v.x.value, v.y.value, v.z.value};
}
template <class Real>
constexpr Vec3<Real> slope(const Vec3<Dual<Real>>& v) {
  return {v.x.slope, v.y.slope, v.z.slope};
}
/// A vector and its derivative.
template <class Real>
constexpr Vec3<Dual<Real>> dual(const Vec3<Real>& v, const Vec3<Real>& s) {
  return {{v.x, s.x}, {v.y, s.y}, {v.z, s.z}};
}

template <class Real>
constexpr Dual<Real> norm2(const Vec3<Dual<Real>>& a) {
  const Real half_slope = dot(value(a), slope(a));
  return {norm2(value(a)), half_slope + half_slope};
}

/// The derivative of a power is d r⁻ⁿ = −(n/2) r⁻ⁿ d(r²)/r².
template <class Real>
class InversePowers<Dual<Real>> {
 public:
  InversePowers() = default;
  explicit InversePowers(const Dual<Real>& r2)
      : powers_(r2.value), relative_(r2.slope * powers_.second()) {}
  Dual<Real> first() const { return with_slope(powers_.first(), -0.5); }
  Dual<Real> second() const { return with_slope(powers_.second(), -1); }
  Dual<Real> third() const { return with_slope(powers_.third(), -1.5); }

 private:
  Dual<Real> with_slope(Real power, double factor) const {
    return {power, power * (constant<Real>(factor) * relative_)};
  }
  InversePowers<Real> powers_;
  Real relative_;
};

template <class Real>
Dual<Real> inverse_sqrt(Dual<Real> a) {
  return InversePowers<Dual<Real>>(a).first();
}

/// Evaluates a polynomial Σ cₙ yⁿ by Horner's rule, one coefficient per call, so that a loop can
/// evaluate several polynomials at once. The coefficients are supplied from the highest to the
/// lowest.
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
