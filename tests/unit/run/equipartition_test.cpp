// SPDX-License-Identifier: MIT
// The extrapolation of temperatures to zero step, from points with a known limit.
#include "run/study/equipartition.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <vector>

#include "polhode/integrate/scheme_text.hpp"
#include "polhode/math/random.hpp"

using namespace polhode;

namespace {

using Excess = std::array<std::optional<Estimate>, 3>;

EfficiencyPoint point(const std::string& scheme, double step, const Excess& excess) {
  EfficiencyPoint p;
  p.scheme = scheme, p.order = scheme_of(scheme).order(), p.step = step, p.excess = excess;
  p.runs = 4;
  return p;
}

// Sums of a few products in double, with h^k down to 1e-12 in units of the slopes.
const double rounding = 1e-12;

}  // namespace

TEST_CASE("an excess proportional to the order of the scheme is extrapolated to its known limit") {
  for (const auto& [scheme, order] : {std::pair("hoa2", 2), {"gier4", 4}}) {
    const auto shown_scheme = scheme;
    CAPTURE(shown_scheme);
    Curve curve{scheme, {}, 3};
    for (const double h : {0.001, 0.002, 0.004}) {
      const double x = std::pow(h, order);
      // Unequal errors do not matter for points on a line; an atom has no rotation.
      const double error = 10 * h;
      curve.points.push_back(
          point(scheme, h,
                {Estimate{0.5 - 3e4 * x, error}, Estimate{-0.25 + 2e5 * x, error}, std::nullopt}));
    }
    for (EfficiencyPoint& p : curve.points)  // the same lines, of other motions
      p.configurational_excess = {p.excess[1], std::nullopt, p.excess[0], std::nullopt};
    // Points beyond the stability limit do not count.
    curve.points.push_back(point(scheme, 0.008, {Estimate{1000, 0.1}, {}, Estimate{1000, 0.1}}));
    const std::vector<EquipartitionFit> fits = equipartition({curve});
    REQUIRE(fits.size() == 1);
    const EquipartitionFit& fit = fits[0];
    CHECK(fit.scheme == scheme);
    CHECK(fit.order == order);
    REQUIRE(fit.axes[0]);
    REQUIRE(fit.axes[1]);
    CHECK(std::abs(fit.axes[0]->intercept.value - 0.5) < rounding);
    CHECK(std::abs(fit.axes[0]->slope.value / -3e4 - 1) < rounding / std::pow(0.004, order) / 1e4);
    CHECK(std::abs(fit.axes[1]->intercept.value + 0.25) < rounding);
    CHECK(!fit.axes[2]);
    REQUIRE(fit.configurational[0]);
    REQUIRE(fit.configurational[2]);
    CHECK(fit.configurational[0]->intercept.value == fit.axes[1]->intercept.value);
    CHECK(fit.configurational[2]->slope.value == fit.axes[0]->slope.value);
    CHECK(!fit.configurational[1]);
    CHECK(!fit.configurational[3]);
  }
}

// Through two points the limit at h = 0 is (4 y₁ − y₂)/3 for steps h and 2h at order 2, and its
// error follows from the pooled one, √((0.3² + 0.6²)/2), with 3 + 3 degrees of freedom.
TEST_CASE("the error of the limit is that of its two points, pooled") {
  const Curve curve{"velocity-verlet",
                    {point("velocity-verlet", 0.001, {Estimate{1, 0.3}, {}, {}}),
                     point("velocity-verlet", 0.002, {Estimate{7, 0.6}, {}, {}})},
                    2};
  const EquipartitionFit fit = equipartition({curve})[0];
  REQUIRE(fit.axes[0]);
  CHECK(fit.axes[0]->intercept.value == doctest::Approx(-1).epsilon(rounding));
  CHECK(fit.axes[0]->intercept.error ==
        doctest::Approx(std::hypot(0.3, 0.6) / std::sqrt(2) * std::hypot(4, 1) / 3)
            .epsilon(rounding));
  CHECK(fit.axes[0]->degrees_of_freedom == 6);
}

TEST_CASE("one step, or points without an error, give no limit") {
  Curve curve{"hoa2", {point("hoa2", 0.001, {Estimate{1, 0.1}, Estimate{1, 0.1}, {}})}, 1};
  CHECK(!equipartition({curve})[0].axes[0]);
  curve.points.push_back(point("hoa2", 0.002, {Estimate{2, 0}, Estimate{2, 0.1}, {}}));
  curve.usable = 2;
  const EquipartitionFit fit = equipartition({curve})[0];
  CHECK(!fit.axes[0]);  // one run gives no error
  CHECK(fit.axes[1]);
}

TEST_CASE("a pooled error of fewer than four degrees of freedom gives no limit") {
  Curve curve{"hoa2",
              {point("hoa2", 0.001, {Estimate{1, 0.1}, {}, {}}),
               point("hoa2", 0.002, {Estimate{2, 0.1}, {}, {}})},
              2};
  for (EfficiencyPoint& p : curve.points) p.runs = 3;
  CHECK(equipartition({curve})[0].axes[0]);
  for (EfficiencyPoint& p : curve.points) p.runs = 2;
  CHECK(!equipartition({curve})[0].axes[0]);
}

// An excess of −2·10⁶ h² − 10¹² h⁴ at 4, 5 and 6 fs deviates from a line by many errors of 0.1 K.
TEST_CASE("steps too long for a + b h^k are left out, and no limit is given without three steps") {
  const auto at = [](double h) {
    return point("hoa2", h,
                 {Estimate{-2e6 * h * h - (h > 0.0035 ? 1e12 * std::pow(h, 4) : 0), 0.1}, {}, {}});
  };
  Curve curve{"hoa2", {at(0.001), at(0.002), at(0.003), at(0.004), at(0.005)}, 5};
  const auto fit = equipartition({curve})[0].axes[0];
  REQUIRE(fit);
  CHECK(std::abs(fit->intercept.value) < 1e-6);
  CHECK(fit->degrees_of_freedom == 15);
  curve = {"hoa2", {at(0.004), at(0.005), at(0.006)}, 3};
  CHECK(!equipartition({curve})[0].axes[0]);
}

// Studies of three runs at four steps without an excess: the limit over its error has Student's t
// distribution with eight degrees of freedom, beyond 2.306 in 5 %, of 2000 studies 100 ± 10.
// Errors of each point from its own three runs would put it there in 22 %.
TEST_CASE("the limit of small studies deviates from the truth as often as its error says") {
  Random random(5);
  constexpr int studies = 2000, runs = 3;
  int beyond = 0;
  for (int n = 0; n < studies; ++n) {
    Curve curve{"hoa2", {}, 4};
    for (const double h : {0.001, 0.002, 0.003, 0.004}) {
      std::array<double, runs> values;
      for (double& x : values) x = 3 * random.normal();
      curve.points.push_back(point("hoa2", h, {mean(values), {}, {}}));
      curve.points.back().runs = runs;
    }
    const auto fit = equipartition({curve})[0].axes[0];
    if (fit && std::abs(fit->intercept.value) > 2.306 * fit->intercept.error) ++beyond;
  }
  CHECK(beyond > 100 - 4 * 10);
  CHECK(beyond < 100 + 4 * 10);
}
