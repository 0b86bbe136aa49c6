// SPDX-License-Identifier: MIT
#include "ensemble/velocity_rescaling.hpp"

#include <cmath>

namespace polhode {
namespace {

/// A random variate of the gamma distribution with shape a ≥ 1 [marsaglia2000].
double gamma_variate(double a, Random& random) {
  const double d = a - 1.0 / 3, c = 1 / std::sqrt(9 * d);
  for (;;) {
    const double x = random.normal();
    const double v = (1 + c * x) * (1 + c * x) * (1 + c * x);
    if (v > 0 && std::log(random.uniform()) < x * x / 2 + d - d * v + d * std::log(v)) return d * v;
  }
}

/// A random sum of the squares of n independent normal deviates, where n ≥ 0 need not be an
/// integer.
double sum_of_squares(double n, Random& random) {
  if (n <= 0) return 0;
  if (n >= 2) return 2 * gamma_variate(n / 2, random);
  // a variate of shape a < 1 is a variate of shape a + 1 times u^{1/a}
  const double a = n / 2;
  return 2 * gamma_variate(a + 1, random) * std::pow(random.uniform(), 1 / a);
}

}  // namespace

double rescaling_factor(double kinetic, double n, double kT, double ratio, Random random) {
  if (n <= 0 || kinetic <= 0 || ratio == 0) return 1;
  const double c = std::exp(-ratio);
  const double b = -std::expm1(-ratio) * kT / (2 * kinetic);  // (1 − c) K̄/(n K) with K̄ = n kT/2
  const double R = random.normal();
  const double S = sum_of_squares(n - 1, random);
  const double along = std::sqrt(c) + R * std::sqrt(b);  // α times the first momentum; its sign is
                                                         // the sign of α
  return std::copysign(std::sqrt(along * along + b * S), along);
}

}  // namespace polhode
