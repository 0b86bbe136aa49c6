// SPDX-License-Identifier: MIT
// Theta functions compared with reference values, and the two methods for the integral of the third
// kind with each other.
#include "polhode/math/theta.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "polhode/rotor/free_rotor.hpp"

using namespace polhode;
using Complex = std::complex<double>;

namespace {

constexpr double relative_epsilon = 0x1p-53;  // one rounding

/// mpmath 1.3, mp.dps = 40: jtheta(4, z, q), jtheta(4, z, q, 1), jtheta(2, z, q) at z = x + iy,
/// with the doubles x, y, q.
struct ThetaRow {
  double x, y, q;
  Complex theta4, slope4, theta2;
};
// clang-format off
const ThetaRow theta_rows[] = {
    {0.3, 0.0, 0.04, {0.93397500607904777374, 0.0}, {0.090323707585788507063, 0.0}, {0.85536850845999703442, 0.0}},
    {0.7, 1.25, 0.04, {0.91625898041914873527, 0.47684652051936692405}, {0.966380957827500755, 0.16596563184056265722}, {1.276492923510823244, -0.94928390371928678587}},
    {1.5, -0.5, 0.01, {1.0305528372493011907, -0.0033169083063997402892}, {0.008710466162148806914, 0.04653789314041792826}, {0.050416520033145752146, 0.32861239090010991106}},
    {-2.0, 3.0, 0.001, {1.2637002538789500723, 0.30531420269133134521}, {0.61063623113158306699, -0.52739397951405292281}, {-1.4886814584666491511, 3.2393478558853446257}},
    {0.25, 0.5, 0.04321, {0.88298588010761426097, 0.04866960472991213138}, {0.12777740585232221402, 0.17820147650637364389}, {0.99919724910326576652, -0.12002845596330959089}},
};
// clang-format on

/// mpmath 1.3, mp.dps = 40, with κ = sqrt(n(1+n)(n+m)): the rate is
/// κ (1 − ellippi(−n, m)/ellipk(m))/n, and the integral κ quad(sn²/(1 + n sn²)) from 0 to v in
/// eight panels, sn = ellipfun('sn', u, m=m).
struct IntegralRow {
  double n, m, v, rate, integral;
};
// clang-format off
constexpr IntegralRow integral_rows[] = {
    {1, 0x1p-10, 1.25, 0.41445769325022081035, 0.42791049108642196856},
    {0.75, 0.25, 1.0, 0.38427000396725823519, 0.23022263024409585885},
    {0x1p-40, 0x1p-40, 1.0, 6.431098710768011512e-13, 3.5072079560864944766e-13},
    {0.0625, 0.5, -1.5, 0.1001436564664510014, -0.12253601094831814411},
    {0.0625, 0.75, 2.0, 0.12937798862570613074, 0.2448543341158312147},
    {0x1p-30, 0.875, 2.0, 0.000017791902024675159295, 0.000030621033827363913133},
    {1, 0.9375, 0.5, 0.71686986236670486703, 0.066217462099425317947},
    {0.5, 1 - 0x1p-20, 7.0, 0.63311098957310214056, 4.3342684271910825561},
};
// clang-format on

}  // namespace

TEST_CASE("theta series gives theta functions of complex argument") {
  const Complex i{0, 1};
  for (const auto& [x, y, q, theta4, slope4, theta2] : theta_rows) {
    const auto shown_x = x;
    CAPTURE(shown_x);
    const auto shown_q = q;
    CAPTURE(shown_q);
    const Complex z{x, y};
    const auto [S, D] = theta_series(q * std::exp(-2.0 * i * z), q * std::exp(2.0 * i * z), q);
    // The arguments contribute 2|z| + 2 roundings to terms of at most 1, whose sums are below 2.
    const double bound = 16 * relative_epsilon * (1 + std::abs(z));
    CHECK(std::abs(S - theta4) <= bound);
    CHECK(std::abs(-2.0 * i * D - slope4) <= bound);
    const Complex w = y > 0 ? -z : z;  // θ₂ is even, and the series requires |e^{−2iw}| ≤ 1
    const Complex S2 = theta_series(-std::exp(-2.0 * i * w), -q * q * std::exp(2.0 * i * w), q).S;
    const Complex found = std::pow(q, 0.25) * std::exp(i * w) * S2;
    CHECK(std::abs(found - theta2) <= bound * std::abs(std::exp(i * w)));
  }
}

TEST_CASE("theta integral of the third kind is linear plus the argument of a theta function") {
  for (const auto& [n, m, v, rate, value] : integral_rows) {
    const auto shown_n = n;
    CAPTURE(shown_n);
    const auto shown_m = m;
    CAPTURE(shown_m);
    const Modulus modulus{std::sqrt(m), std::sqrt(1 - m)};
    REQUIRE(ThetaIntegral::applies(modulus));
    const double K = quarter_period(modulus);
    const ThetaIntegral integral(n, modulus, K);
    // Rate and argument are sums of about eight rounded numbers that are at most 1.
    CHECK(std::abs(integral.rate() - rate) <= 8 * relative_epsilon);
    CHECK(std::abs(integral.rate() * v - integral.argument(v) - value) <=
          8 * relative_epsilon * (1 + std::abs(v)));
  }
}

// Both methods use the same n, k, k', K and p t. The integral is p t times a mean rate plus a
// bounded part, and both compute the rate from about eight rounded numbers that are at most 1
// (κ/(1+n), the largest rate, is below 1 as n and k are): hence 16 roundings of 1 + |p t|.
TEST_CASE("theta functions and Carlson's integral agree on regular tops over many periods") {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> mass(0.1, 1), exponent(-2, 4);
  std::normal_distribution<double> normal;
  double max_periods = 0;
  int ordinary = 0, complementary = 0;
  for (int k = 0; k < 20000; ++k) {
    const double a = mass(random), b = mass(random), c = mass(random);
    const Vec3<double> J{b + c, c + a, a + b}, L{normal(random), normal(random), normal(random)};
    const double speed = std::hypot(L.x / J.x, L.y / J.y, L.z / J.z);
    const double t = std::copysign(std::pow(10, exponent(random)), normal(random)) / speed;
    const ScaledTop top(J, L, t);
    const Orbit orbit(top);
    REQUIRE(ThetaIntegral::applies(orbit.modulus));  // no regular top needs the other method
    ++(orbit.modulus.k > orbit.modulus.complement ? complementary : ordinary);

    const PrecessionAngle phi(orbit);
    const Orbit::Elapsed v = orbit.elapsed(top.t);
    max_periods = std::fmax(max_periods, std::abs(v.half_periods) / 2);
    const double by_theta = phi.by_theta(top.t, v), by_carlson = phi.by_carlson(v);
    CAPTURE(speed * t);
    CAPTURE(orbit.modulus.k);
    CHECK(std::abs(by_theta - by_carlson) <=
          16 * relative_epsilon * (1 + std::abs(orbit.p * top.t)));
  }
  CHECK(max_periods > 500);
  CHECK(ordinary > 1000);
  CHECK(complementary > 1000);
}

// The bound is that of regular tops. Initial L near the middle axis have a complementary modulus as
// small as their components perpendicular to it; quarter periods K = ln(4/k') reach 690, and t
// covers up to hundreds of periods.
TEST_CASE("theta functions and Carlson's integral agree however near the separatrix") {
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> mass(0.1, 1), exponent(-300, -8), time(-2, 5);
  std::normal_distribution<double> normal;
  double nearest = 1, max_half_periods = 0;
  int on_it = 0;
  for (int k = 0; k < 5000; ++k) {
    const double a = mass(random), b = mass(random), c = mass(random);
    const double small = k % 10 == 0 ? 0.0 : std::pow(10, exponent(random));
    Vec3<double> J{b + c, c + a, a + b}, L{normal(random), normal(random), normal(random)};
    if (k % 2 == 0) {  // near the middle axis
      L = small * L;
      const std::size_t middle = (a < b) == (b < c) ? 1 : (b < a) == (a < c) ? 0 : 2;
      L[middle] = normal(random);
    } else {  // anywhere on the separatrix: alpha and beta differ by a rounding or not at all
      J = {12, 15, 20};
      L = {normal(random), normal(random), 0};
      L.z = std::copysign(L.x, normal(random));
      if (k % 3 == 0) L.z *= 1 + 0x1p-52;
    }
    const double speed = std::hypot(L.x / J.x, L.y / J.y, L.z / J.z);
    const double t = std::copysign(std::pow(10, time(random)), normal(random)) / speed;
    const ScaledTop top(J, L, t);
    if (Orbit::is_stationary(top)) continue;
    const Orbit orbit(top);
    REQUIRE(ThetaIntegral::applies(orbit.modulus));
    if (orbit.modulus.complement == 0)
      ++on_it;
    else
      nearest = std::fmin(nearest, orbit.modulus.complement);
    const PrecessionAngle phi(orbit);
    const Orbit::Elapsed v = orbit.elapsed(top.t);
    max_half_periods = std::fmax(max_half_periods, std::abs(v.half_periods));
    const double by_theta = phi.by_theta(top.t, v), by_carlson = phi.by_carlson(v);
    CAPTURE(speed * t);
    CAPTURE(orbit.modulus.complement);
    CHECK(std::abs(by_theta - by_carlson) <=
          16 * relative_epsilon * (1 + std::abs(orbit.p * top.t)));
    const JacobiFunctions u = orbit.at(v);
    const Vec3<double> later = orbit.L_at(u);
    CHECK(std::abs(norm(later) - orbit.norm_L()) <= 16 * relative_epsilon * orbit.norm_L());
  }
  CHECK(nearest < 1e-290);
  CHECK(on_it > 500);
  CHECK(max_half_periods > 100);
}
