// SPDX-License-Identifier: MIT
#include "polhode/model/short_range.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "polhode/base/error.hpp"

namespace polhode {
namespace {

constexpr double max_deviation = 0.01;  // largest relative deviation of a tabulated force from the
                                        // force of the spline

// Slopes of the clamped cubic spline at the knots, in units of energy per interval. The slopes at
// the ends are given, and continuity of the second derivative requires s₋ + 4 s + s₊ = 3 (u₊ − u₋).
std::vector<double> spline_slopes(const std::vector<double>& u, double first, double last) {
  const std::size_t n = u.size();
  std::vector<double> slope(n), factor(n);
  slope.front() = first;
  slope.back() = last;
  for (std::size_t k = 1; k + 1 < n; ++k) {  // forward elimination
    factor[k] = 1 / (4 - factor[k - 1]);
    slope[k] = (3 * (u[k + 1] - u[k - 1]) - slope[k - 1]) * factor[k];
  }
  for (std::size_t k = n - 2; k > 0; --k) slope[k] -= factor[k] * slope[k + 1];
  return slope;
}

}  // namespace

PotentialTable::PotentialTable(std::string name, double first, double spacing,
                               const std::vector<double>& u, const std::vector<double>& f)
    : name_(std::move(name)), first_(first), spacing_(spacing) {
  const std::vector<double> slope = spline_slopes(u, -f.front() * spacing, -f.back() * spacing);
  for (std::size_t k = 1; k + 1 < u.size(); ++k) {
    const double scale = std::max({std::abs(f[k - 1]), std::abs(f[k]), std::abs(f[k + 1])});
    const double spline = -slope[k] / spacing;
    if (std::abs(spline - f[k]) > max_deviation * scale)
      throw Error(fmt::format(
          "the force at r = {:g} nm is {:g} kJ/mol/nm, but the slope of the energies is {:g} "
          "kJ/mol/nm; the force must equal minus the slope within {:g} %: check columns and units, "
          "or use a finer grid",
          first + static_cast<double>(k) * spacing, f[k], -spline, 100 * max_deviation));
  }
  for (std::size_t k = 0; k + 1 < u.size(); ++k) {
    const double rise = u[k + 1] - u[k];
    exact_.insert(exact_.end(), {u[k], slope[k], 3 * rise - 2 * slope[k] - slope[k + 1],
                                 slope[k] + slope[k + 1] - 2 * rise});
  }
  rounded_.assign(exact_.begin(), exact_.end());
}

const char* name(const ShortRangeLaw& law) {
  constexpr const char* names[] = {"lennard-jones", "mie", "buckingham", "tabulated"};
  return names[law.index()];
}

std::string parameters(double sigma, double epsilon, const ShortRangeLaw& law) {
  std::string depth = fmt::format("sigma {} nm, epsilon {} kJ/mol", sigma, epsilon);
  if (const auto* mie = std::get_if<MieLaw>(&law))
    return fmt::format("{}, exponents {} and {}", depth, mie->n, mie->m);
  if (const auto* exp6 = std::get_if<BuckinghamLaw>(&law))
    return fmt::format("A {} kJ/mol, B {} 1/nm, C {} kJ/mol nm6", exp6->A, exp6->B, exp6->C);
  if (const auto* tabulated = std::get_if<TabulatedLaw>(&law))
    return fmt::format("table {}", tabulated->table->name());
  return depth;
}

void check(double sigma, double epsilon, const ShortRangeLaw& law) {
  if (!(epsilon >= 0 && sigma >= 0) || !std::isfinite(epsilon) || !std::isfinite(sigma))
    throw Error(fmt::format(
        "sigma is {} nm and epsilon {} kJ/mol; both must be finite and 0 or more", sigma, epsilon));
  if (epsilon > 0 && sigma == 0)
    throw Error(
        fmt::format("epsilon is {} kJ/mol, but sigma is 0 nm; the law '{}' needs both parameters",
                    epsilon, name(law)));
  if (const auto* mie = std::get_if<MieLaw>(&law))
    if (!(mie->m > 3 && mie->n > mie->m && mie->n <= 100))
      throw Error(fmt::format(
          "the exponents are {} and {}; the attractive exponent must be above 3 (finite energy of "
          "a fluid), and the repulsive exponent must be larger than that and at most 100",
          mie->n, mie->m));
  if (const auto* exp6 = std::get_if<BuckinghamLaw>(&law)) {
    const auto& [A, B, C] = *exp6;
    if (!(A > 0 && B > 0 && C >= 0) || !std::isfinite(A + B + C))
      throw Error(
          fmt::format("the Buckingham potential has A = {} kJ/mol, B = {} 1/nm and C = {} kJ/mol "
                      "nm6; A and B must be above 0 and C 0 or more",
                      A, B, C));
    // The slope u' of the Buckingham potential is 0 where (B r)⁷ exp(−B r) = 6 C B⁶/A. The function
    // x⁷ exp(−x) is largest at x = B r = 7.
    if (6 * C * std::pow(B, 6) / A >= std::pow(7 * std::exp(-1), 7))
      throw Error(fmt::format(
          "with A = {} kJ/mol, B = {} 1/nm and C = {} kJ/mol nm6 the sites attract each "
          "other at all distances; A must be larger, or C smaller",
          A, B, C));
  }
}

}  // namespace polhode
