// SPDX-License-Identifier: MIT
#include "forces/laws/gaussian_smooth_part.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "polhode/base/error.hpp"

namespace polhode {
namespace {

// In a Chebyshev series of a high degree, the coefficients of powers of y are large and nearly
// cancel. With long double, the error of the sum of these terms is 1e-15.
using Real = long double;
constexpr std::size_t degree = SmoothPolynomial::max_degree, nodes = 3 * degree;

// The function erf(x √t)/√t with t = 1 − y.
Real smooth(Real x, Real y) {
  const Real root = std::sqrt(1 - y);
  return root > 0 ? std::erf(x * root) / root : 2 * x * std::numbers::inv_sqrtpi_v<Real>;
}

// Coefficients c of the series Σ c_n T_n(2 y − 1) for y from 0 to 1, where the first coefficient is
// halved.
std::array<Real, degree + 1> chebyshev_series(Real x) {
  std::array<Real, degree + 1> c{};
  for (std::size_t k = 0; k < nodes; ++k) {
    const Real theta = std::numbers::pi_v<Real> * (static_cast<Real>(k) + 0.5L) / nodes;
    const Real value = smooth(x, (1 + std::cos(theta)) / 2);
    for (std::size_t n = 0; n <= degree; ++n)
      c[n] += 2 * value * std::cos(static_cast<Real>(n) * theta) / nodes;
  }
  c[0] /= 2;
  return c;
}

// The number of Chebyshev terms that the value and its derivative need. The terms of the derivative
// are up to n² times as large.
std::size_t terms_needed(const std::array<Real, degree + 1>& c) {
  constexpr Real negligible = 1e-11L;
  std::size_t last = degree;
  while (last > 1 && std::abs(c[last]) * static_cast<Real>(last * last) < negligible) --last;
  return last + 1;
}

}  // namespace

SmoothPolynomial gaussian_smooth_part(double cutoff, double alpha) {
  const double x = alpha * cutoff;
  if (!(x > 0 && x <= max_gaussian))
    throw Error(fmt::format(
        "the Ewald parameter times the cutoff of the charges is {:.4g}; the product must be above "
        "0 and at most {:g}, so use a shorter cutoff or a less accurate mesh",
        x, max_gaussian));
  const auto c = chebyshev_series(x);
  const std::size_t count = terms_needed(c);
  // The recursion T_(n+1) = 2 (2 y − 1) T_n − T_(n−1), for coefficients of powers of y.
  std::vector<Real> sum(count), before(count), now(count), next(count);
  before[0] = 1;
  now[0] = -1, now[1] = 2;
  sum[0] = c[0];
  for (std::size_t n = 1; n < count; ++n) {
    for (std::size_t k = 0; k <= n; ++k) sum[k] += c[n] * now[k];
    for (std::size_t k = 0; k < count; ++k)
      next[k] = (k > 0 ? 4 * now[k - 1] : 0) - 2 * now[k] - before[k];
    before = now;
    now = next;
  }
  return {cutoff, std::vector<double>(sum.begin(), sum.end())};
}

}  // namespace polhode
