// SPDX-License-Identifier: MIT
// The short-range laws as functions of one distance, and how those of unlike sites are mixed.
#include "forces/laws/short_range.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "../errors.hpp"
#include "forces/laws/law_range.hpp"
#include "math/dual.hpp"
#include "polhode/base/error.hpp"

using namespace polhode;

namespace {

const BuckinghamLaw argon{1.0177e6, 36.63, 6.1426e-3};

template <class Law>
PairValue<double> at(const Law& law, double r) {
  return law(InversePowers<double>(r * r), r * r);
}

// The table of a Lennard-Jones law, as its file would have it.
TabulatedLaw lennard_jones_table(double sigma, double epsilon, double spacing) {
  const auto law = LennardJones<>::of(sigma, epsilon);
  std::vector<double> u, f;
  for (double r = 0.25; r < 1.2; r += spacing) {
    u.push_back(at(law, r).u);
    f.push_back(at(law, r).s * r);
  }
  return {std::make_shared<const PotentialTable>("lj.txt", 0.25, spacing, u, f)};
}

std::vector<ShortRange<double>> one_of_each() {
  return {short_range(0.34, 1.0, LennardJonesLaw{}), short_range(0.34, 1.0, MieLaw{14.3, 5.7}),
          short_range(0, 0, argon), short_range(0, 0, lennard_jones_table(0.34, 1.0, 0.002))};
}

}  // namespace

// s = −u'/r, the slope of u from dual numbers: both to rounding, in which repulsion and attraction
// cancel by two digits at most at these distances.
TEST_CASE("each short-range law's s is minus its slope over r") {
  for (const ShortRange<double>& law : one_of_each())
    for (double r = 0.26; r < 1.1; r += 0.0371) {
      CAPTURE(r);
      const Dual<double> x(r, 1.0);
      const auto value = law(InversePowers<Dual<double>>(x * x), x * x);
      CHECK(value.s.value == doctest::Approx(-value.u.slope / r).epsilon(1e-11));
      CHECK(value.u.value == doctest::Approx(at(law, r).u).epsilon(1e-13));
    }
}

// Both are rounded a few times; powers of the factor multiply this by at most 12.
TEST_CASE("a potential with scaled distances is the potential at scaled distances") {
  const std::vector<ShortRange<double>> laws = one_of_each();
  for (std::size_t k = 0; k < 3; ++k)
    for (const double factor : {0.4, 0.9})
      for (double r = 0.3; r < 1.1; r += 0.0371) {
        CAPTURE(k);
        CAPTURE(r);
        const PairValue<double> scaled = at(laws[k].scaled_by(factor), factor * r);
        const PairValue<double> plain = at(laws[k], r);
        const double scale = 1e-13 * at(ShortRange<double>(LennardJones<>::of(0.34, 1)), 0.26).u;
        CHECK(std::abs(scaled.u - plain.u) < scale);
        CHECK(std::abs(scaled.s * factor * factor - plain.s) < 12 * scale / (r * r));
      }
  CHECK(std::isnan(at(laws[2].scaled_by(0.5),
                      0.5 * 0.99 * std::sqrt(std::get<Buckingham<>>(laws[2].law()).inner_limit2))
                       .u));
  CHECK(at(laws[3].scaled_by(1), 0.5).u == at(laws[3], 0.5).u);
  CHECK_THROWS_AS(laws[3].scaled_by(0.5), Error);
}

// exp(n/2 ln(σ²/r²)) errs by some n |ln(σ/r)| + 2 roundings of 2⁻⁵³, here below 20 of the larger
// term, of which attraction leaves a tenth at least but next to the zeros.
TEST_CASE("Mie 12-6 is Lennard-Jones") {
  const auto mie = Mie<>::of(0.34, 0.9, {12, 6});
  const auto lj = LennardJones<>::of(0.34, 0.9);
  for (double r = 0.25; r < 1.2; r += 0.0137) {
    const double x = std::pow(0.34 / r, 6), bound = 20 * 0x1p-53 * 4 * 0.9 * (x * x + x);
    CHECK(std::abs(at(mie, r).u - at(lj, r).u) < bound);
    CHECK(std::abs(at(mie, r).s - at(lj, r).s) < 12 * bound / (r * r));
  }
}

// The well of a Mie law is ε deep whatever its exponents, at r = (n/m)^(1/(n − m)) σ, and σ is
// where it crosses 0.
TEST_CASE("a Mie law has the depth and diameter that it says") {
  for (const MieLaw& law : {MieLaw{12, 6}, MieLaw{42.553, 5.1906}, MieLaw{9, 3.5}}) {
    const auto mie = Mie<>::of(0.4, 0.7, law);
    const double r = 0.4 * std::pow(law.n / law.m, 1 / (law.n - law.m));
    CHECK(at(mie, r).u == doctest::Approx(-0.7).epsilon(1e-13));
    CHECK(std::abs(at(mie, r).s) < 1e-11);
    CHECK(std::abs(at(mie, 0.4).u) < 1e-14);
  }
}

// A clamped cubic spline errs by at most 5/384 h⁴ max|u⁗|, its slope by h³/24 max|u⁗| [hall1976];
// u⁗ of Lennard-Jones is largest at the first point: 4 ε (12 13 14 15 (σ/r)¹² + …)/r⁴. Halving h
// shows the order.
TEST_CASE("a tabulated Lennard-Jones law errs as a cubic spline does") {
  const double sigma = 0.3, epsilon = 1, first = 0.25;
  const auto lj = LennardJones<>::of(sigma, epsilon);
  const double x = std::pow(sigma / first, 6);
  const double u4 = 4 * epsilon * (32760 * x * x) / std::pow(first, 4);
  double before = 0;
  for (const double h : {0.004, 0.002, 0.001}) {
    const auto table = Tabulated<>::of(0, 0, lennard_jones_table(sigma, epsilon, h));
    double worst = 0;
    for (double r = first; r < 1.19; r += 0.137 * h) {
      worst = std::max(worst, std::abs(at(table, r).u - at(lj, r).u));
      CHECK(std::abs(at(table, r).s - at(lj, r).s) * r < h * h * h / 24 * u4);
    }
    CHECK(worst < 5.0 / 384 * std::pow(h, 4) * u4);
    if (before > 0) CHECK(std::log2(before / worst) > 3.7);
    before = worst;
  }
}

// Class C²: the slope of s is the same on both sides of a point of the table.
TEST_CASE("a tabulated law is of class C² and stays finite beyond its end") {
  const auto law = Tabulated<>::of(0, 0, lennard_jones_table(0.34, 1, 0.01));
  const auto slope = [&](double r) {
    const Dual<double> x(r, 1.0);
    return law(InversePowers<Dual<double>>(x * x), x * x).s.slope;
  };
  for (const double r : {0.30, 0.41, 0.52}) {
    CAPTURE(r);
    CHECK(slope(r - 1e-9) == doctest::Approx(slope(r + 1e-9)).epsilon(1e-4));
  }
  CHECK(at(law, 5.0).u == doctest::Approx(at(law, law.table->last()).u).epsilon(1e-12));
  CHECK(at(law, 5.0).s == 0);
}

TEST_CASE("below its inner limit a law is not a number") {
  const double r = inner_limit(argon);
  const auto law = Buckingham<>::of(0, 0, argon);
  CHECK(r > 0.05);
  CHECK(r < 0.1);
  // u is largest there: s changes sign, and what is below is cut off.
  CHECK(std::abs(at(law, 1.000001 * r).s) < 1e-3 * at(law, 1.2 * r).s);
  CHECK(at(law, 1.000001 * r).s > 0);
  CHECK(std::isnan(at(law, 0.9999 * r).u));
  CHECK(std::isnan(at(law, 0.9999 * r).s));
  const auto table = Tabulated<>::of(0, 0, lennard_jones_table(0.34, 1, 0.002));
  CHECK(std::isnan(at(table, 0.2499).u));
  CHECK(std::isfinite(at(table, 0.2501).u));
  CHECK(std::isnan(at(table, 0.0).u));
  CHECK(inner_limit(MieLaw{}) == 0);
  CHECK(inner_limit(BuckinghamLaw{1e5, 30, 0}) == 0);  // repulsive alone
}

// ∫ u r² dr by Simpson's rule from a to 40 nm, in steps of equal ratio: the rest is below 1e-5 of
// it.
TEST_CASE("the energy beyond a distance is the integral of u") {
  for (const ShortRange<double>& law : one_of_each()) {
    const double a = 0.35;  // where repulsion counts
    double expected = 0;
    try {
      expected = law.integral_beyond(a);
    } catch (const Error&) {
      continue;  // a table
    }
    const int steps = 4000;
    const double h = std::log(40 / a) / steps;
    double sum = 0;
    for (int k = 0; k <= steps; ++k) {
      const double r = a * std::exp(k * h);
      sum += (k == 0 || k == steps ? 1 : k % 2 ? 4 : 2) * at(law, r).u * r * r * r;
    }
    CHECK(sum * h / 3 == doctest::Approx(expected).epsilon(1e-4));
  }
}

TEST_CASE("laws of unlike sites are mixed within a kind and refused between kinds") {
  const auto site = [](double sigma, double epsilon, ShortRangeLaw law) {
    Site s;
    s.name = "X";
    s.sigma = sigma, s.epsilon = epsilon, s.law = std::move(law);
    return s;
  };
  const auto u = [](const ShortRange<double>& law) { return at(law, 0.37).u; };
  const Site m = site(0.3, 0.5, MieLaw{14, 6}), n = site(0.4, 0.8, MieLaw{20, 5});
  CHECK(u(mix(m, n, MixingRule::lorentz_berthelot)) ==
        u(short_range(0.35, std::sqrt(0.4), MieLaw{17, 5.5})));
  CHECK(u(mix(m, n, MixingRule::geometric)) ==
        doctest::Approx(u(short_range(std::sqrt(0.12), std::sqrt(0.4),
                                      MieLaw{std::sqrt(280.0), std::sqrt(30.0)})))
            .epsilon(1e-13));
  const Site a = site(0, 0, argon), b = site(0, 0, BuckinghamLaw{4e6, 40, 2e-3});
  CHECK(u(mix(a, b, MixingRule::lorentz_berthelot)) ==
        doctest::Approx(std::sqrt(argon.A * 4e6) * std::exp(-2 / (1 / argon.B + 1 / 40.0) * 0.37) -
                        std::sqrt(argon.C * 2e-3) / std::pow(0.37, 6))
            .epsilon(1e-12));
  check_error([&] { mix(a, m, MixingRule::geometric); },
              {"buckingham", "mie", "for which there is no mixing rule", "[[pair]]"});
  const Site t = site(0, 0, lennard_jones_table(0.34, 1, 0.002));
  const Site other = site(0, 0, lennard_jones_table(0.35, 1, 0.002));
  CHECK(u(mix(t, t, MixingRule::geometric)) == u(short_range(0, 0, t.law)));
  check_error([&] { mix(t, other, MixingRule::geometric); }, {"tabulated", "lj.txt"});
  CHECK(u(mix(site(0, 0, {}), a, MixingRule::geometric)) == 0);
}

TEST_CASE("parameters out of their domain are refused") {
  check_error([] { check(0, 1, LennardJonesLaw{}); }, {"epsilon is 1 kJ/mol, but sigma is 0 nm"});
  check_error([] { check(0.3, 1, MieLaw{14, 3}); }, {"14 and 3", "above 3"});
  check_error([] { check(0.3, 1, MieLaw{6, 12}); }, {"6 and 12"});
  check_error([] { check(0, 0, BuckinghamLaw{-1, 30, 0}); }, {"A = -1", "above 0"});
  check_error(
      [] {
        check(0, 0, BuckinghamLaw{1, 30, 1});
      },
      {"attract each other at all distances"});
  CHECK_NOTHROW(check(0, 0, argon));
  // A force column in other units than the energies.
  std::vector<double> u, f;
  for (int k = 0; k < 20; ++k) u.push_back(std::exp(-0.1 * k)), f.push_back(u.back());
  check_error([&] { PotentialTable("t", 0.3, 0.01, u, f); },
              {"the force at r = 0.31 nm is", "1 %"});
}
