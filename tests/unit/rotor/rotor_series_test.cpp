// SPDX-License-Identifier: MIT
// The truncation error of the series is below rounding within its radius, for any shape.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <random>

#include "polhode/rotor/free_rotation.hpp"

using namespace polhode;

namespace {

using Long = long double;  // 64 bits of mantissa: ε/2048

/// The rotation by a plain Taylor series of q' = q (0, ω)/2 and L' = L × ω: independent of the
/// series under test.
Quaternion<Long> taylor_rotation(const Vec3<Long>& inverse_J, const Vec3<Long>& L) {
  constexpr int order = 36;  // (0.6)³⁶/36! is negligible
  std::array<Quaternion<Long>, order + 1> q;
  std::array<Vec3<Long>, order + 1> l, w;
  l[0] = L;
  w[0] = scaled(inverse_J, L);
  Quaternion<Long> r = q[0];
  for (std::size_t n = 0; n < order; ++n) {
    Quaternion<Long> dq{0, 0, 0, 0};
    Vec3<Long> dl;
    for (std::size_t k = 0; k <= n; ++k) {
      const Vec3<Long>& v = w[n - k];
      const Quaternion<Long> term = q[k] * Quaternion<Long>{0, v.x, v.y, v.z};
      dq = {dq.w + term.w, dq.x + term.x, dq.y + term.y, dq.z + term.z};
      dl += cross(l[k], v);
    }
    const Long count = static_cast<Long>(n + 1);
    q[n + 1] = scaled(dq, 0.5L / count);
    l[n + 1] = dl * (1 / count);
    w[n + 1] = scaled(inverse_J, l[n + 1]);
    r = {r.w + q[n + 1].w, r.x + q[n + 1].x, r.y + q[n + 1].y, r.z + q[n + 1].z};
  }
  return r;
}

template <class A>
double angle_between(const Quaternion<A>& a, const Quaternion<Long>& b) {
  const Quaternion<Long> u =
      normalized(Quaternion<Long>{Long(a.w), Long(a.x), Long(a.y), Long(a.z)});
  return static_cast<double>(std::fmax(std::fmax(std::abs(u.w - b.w), std::abs(u.x - b.x)),
                                       std::fmax(std::abs(u.y - b.y), std::abs(u.z - b.z))));
}

/// The worst error over random bodies that all turn by |ω t| = angle. Every mass distribution is
/// second moments (a, b, c) along the axes; some are zero or tiny (flat bodies, needles), and ω is
/// near an axis or a plane as often as not, since the worst cases of the bound are there.
template <SeriesOrder order, class Real>
double worst_error(double angle, int count) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::normal_distribution<double> normal;
  double worst = 0;
  for (int n = 0; n < count; ++n) {
    double a = uniform(random), b = uniform(random), c = uniform(random);
    if (n % 4 == 1) a = std::pow(10, -6 * a);
    if (n % 4 == 2) c = 0;
    if (n % 4 == 3) {
      a = std::pow(10, -3 * a);
      c = a * std::pow(10, -6 * c);
    }
    Vec3<double> J{b + c, c + a, a + b};
    for (int k = 0; k < n / 4 % 3; ++k) J = {J.y, J.z, J.x};
    if (n / 12 % 2 == 0) J = {J.y, J.x, J.z};
    Vec3<double> w{normal(random), normal(random), normal(random)};
    if (uniform(random) < 0.4) w[static_cast<std::size_t>(n % 3)] *= 1e-3;
    if (uniform(random) < 0.4) w[static_cast<std::size_t>((n + 1) % 3)] *= 1e-2;
    w *= angle / norm(w);

    const Vec3<Real> inverse_J{Real(1 / J.x), Real(1 / J.y), Real(1 / J.z)};
    const Vec3<Real> L{Real(w.x * J.x), Real(w.y * J.y), Real(w.z * J.z)};
    const auto r = unnormalized_rotation<order>(inverse_J, L, Real(1));
    const Quaternion<Long> truth =
        taylor_rotation({Long(inverse_J.x), Long(inverse_J.y), Long(inverse_J.z)},
                        {Long(L.x), Long(L.y), Long(L.z)});
    worst = std::fmax(worst, angle_between(r, truth));
  }
  return worst;
}

}  // namespace

// The bound in the doc comment. Both sides: the worst case must also be found, within the factor by
// which the scan of 40000 shapes may miss it, otherwise the series would be longer than necessary.
TEST_CASE("truncation of the series is below a quarter of an ulp within their radius") {
  const double long_error = worst_error<long_series, Long>(long_series.radius, 40000);
  CHECK(long_error < 3e-17);
  CHECK(long_error > 1e-18);
  const double short_error = worst_error<short_series, Long>(short_series.radius, 40000);
  CHECK(short_error < 3e-17);
  CHECK(short_error > 1e-18);
  const double float_error = worst_error<float_series, Long>(float_series.radius, 10000);
  CHECK(float_error < 0x1p-26);
  CHECK(float_error > 0x1p-32);
}

// With d_n of order (ω t)^(2n+2), the first term cut off after 6 of them grows as (ω t)^15 in the
// vector part; the sine's, (ω t)^15 as well. Past the radius the error rises with this power.
TEST_CASE("series deviate beyond their radius according to their order") {
  const double near = worst_error<short_series, Long>(0.3, 4000);
  const double far = worst_error<short_series, Long>(0.6, 4000);
  CHECK(std::log2(far / near) == doctest::Approx(15).epsilon(0.05));  // next term: 0.3² of it
}

// About 12 roundings act on numbers of size |ω t|/2 <= 0.15, two on w: below 2 ε, so every
// component is good to about one unit in the last place of w.
TEST_CASE("series in double precision have an error of an ulp") {
  CHECK(worst_error<long_series, double>(0.3, 40000) < 2 * 0x1p-53);
  CHECK(worst_error<short_series, double>(0.15, 40000) < 2 * 0x1p-53);
}

TEST_CASE("series in single precision have an error of an ulp of float") {
  CHECK(worst_error<float_series, float>(0.3, 40000) < 2 * 0x1p-24);
}

// Substeps: 2ⁿ, at most twice as many as needed; each adds 4 roundings.
TEST_CASE("rotations beyond the radius of the series are split into equal ones") {
  const Vec3<double> inverse_J{1 / 0.7, 1 / 1.1, 1 / 1.5}, L{0.5, 0.6, -0.4};
  const double speed = norm(scaled(inverse_J, L));
  for (const double angle : {0.31, 0.7, 2.0, 9.0}) {
    const double t = angle / speed;
    const Quaternion<double> r = normalized(series_rotation(inverse_J, L, t));
    const Quaternion<double> truth =
        closed_rotation({0.7, 1.1, 1.5}, L, t).rotation;  // 16 ε (1 + k), k ≈ 5 angle
    const Quaternion<double> off = r * conjugate(truth);
    CHECK(norm(off.vector()) <= 0x1p-53 * (16 * (1 + 5 * angle) + 4 * 2 * angle / 0.15));
  }
}
