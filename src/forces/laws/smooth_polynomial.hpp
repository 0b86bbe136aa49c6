// SPDX-License-Identifier: MIT
// A polynomial in the square of the distance, which is subtracted from 1/r inside a cutoff. The
// remainder goes smoothly to zero at the cutoff. A kernel evaluates the polynomial by a few
// multiplications, without special functions.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

namespace polhode {

/// The value of a radial function and −1/r times its derivative.
struct RadialValue {
  double u;  ///< value u [1/nm]
  double s;  ///< −u'/r [1/nm³]
};

/// The smooth part of 1/r: a polynomial in y = 1 − r²/a² for r < a, and 1/r beyond. The remainder
/// u(r) of 1/r is short-range and vanishes for r ≥ a.
class SmoothPolynomial {
 public:
  static constexpr std::size_t max_degree = 25;  ///< highest power of y

  /// @param cutoff  cutoff a [nm]
  /// @param terms   at least two coefficients, of 1, y, y², … in the smooth part multiplied by a
  SmoothPolynomial(double cutoff, const std::vector<double>& terms)
      : a_(cutoff), degree_(terms.size() - 1) {
    std::copy(terms.begin(), terms.end(), u_.begin());
    for (std::size_t k = 0; k < degree_; ++k) s_[k] = 2 * static_cast<double>(k + 1) * u_[k + 1];
  }

  double cutoff() const { return a_; }
  std::size_t degree() const { return degree_; }
  /// The coefficient of y^k in the smooth part, multiplied by a, for k ≤ degree.
  double coefficient(std::size_t k) const { return u_[k]; }
  /// The coefficient of y^k in −smooth'/r, multiplied by a³, for k < degree.
  double slope_coefficient(std::size_t k) const { return s_[k]; }

  RadialValue smooth(double r) const {
    if (r >= a_) return {1 / r, 1 / (r * r * r)};
    const double y = 1 - r * r / (a_ * a_);
    double u = 0, s = 0;
    for (std::size_t k = degree_ + 1; k-- > 0;) u = u * y + u_[k];
    for (std::size_t k = degree_; k-- > 0;) s = s * y + s_[k];
    return {u / a_, s / (a_ * a_ * a_)};
  }
  RadialValue pair(double r) const {
    if (r >= a_) return {0, 0};
    const RadialValue far = smooth(r);
    return {1 / r - far.u, 1 / (r * r * r) - far.s};
  }
  double smooth_at_zero() const { return smooth(0).u; }

 private:
  double a_;
  std::size_t degree_;
  std::array<double, max_degree + 1> u_{};
  std::array<double, max_degree> s_{};
};

/// The Taylor coefficients of a/r in powers of y, up to y^last: (1/2)_k/k!.
inline std::vector<double> inverse_distance_terms(int last) {
  std::vector<double> u(static_cast<std::size_t>(last) + 1, 1.0);
  for (std::size_t k = 1; k < u.size(); ++k)
    u[k] = u[k - 1] * (static_cast<double>(k) - 0.5) / static_cast<double>(k);
  return u;
}

}  // namespace polhode
