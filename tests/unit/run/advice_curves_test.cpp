// SPDX-License-Identifier: MIT
// Temperatures of the adviser's runs as a curve of a study, from runs whose limit is known.
#include "run/adviser/advice_report.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "polhode/integrate/scheme_text.hpp"
#include "run/study/equipartition.hpp"

using namespace polhode;

namespace {

// Rotation about axis 1 is hotter than translation by 0.5 − 2·10⁵ h² K, and its configurational
// temperature than the kinetic one by −0.25 + 3·10⁵ h² K. Four runs scatter about it by −2 to 2 K.
AdviserPoint point(double step, bool usable = true) {
  AdviserPoint p{step, 1, {}, 0, usable};
  for (const double off : {-1.0, 1.0, -2.0, 2.0}) {
    Outcome run;
    run.ratio = 0.01;
    run.temperatures.all = 300;
    run.temperatures.translation = 300;
    run.temperatures.rotation[0] = 300.5 - 2e5 * step * step + off;
    run.configurational =
        ByMotion<double>{0, run.temperatures.rotation[0] - 0.25 + 3e5 * step * step - off, 0, 0};
    p.runs.push_back(run);
  }
  return p;
}

Advice advice_of(const std::vector<AdviserPoint>& points) {
  Advice advice;
  for (const char* name : {"velocity-verlet", "hoa2"})
    advice.candidates.push_back({name, scheme_of(name), {}, {}, 0, 0, {}});
  advice.candidates[1].points = points;
  return advice;
}

// Sums of a few temperatures of 300 K in double, divided by h² down to 10⁻⁶.
constexpr double rounding = 1e-10;

}  // namespace

TEST_CASE("choosing and confirming runs form one curve with one limit") {
  Advice advice = advice_of({point(0.001), point(0.002), point(0.004, false), point(0.005)});
  advice.refused.emplace_back(1, point(0.003));
  advice.surpassed.emplace_back(1, point(0.0045));
  advice.best = 1;
  advice.confirmation = point(0.0025);
  const std::vector<Curve> all = curves(advice);
  REQUIRE(all.size() == 2);
  CHECK(all[0].points.empty());
  const Curve& curve = all[1];
  CHECK(curve.scheme == "hoa2");
  REQUIRE(curve.points.size() == 7);
  CHECK(curve.usable == 4);  // points beyond a step that drifts do not count
  CHECK(curve.points[2].step == 0.0025);
  CHECK(curve.points[3].step == 0.003);
  CHECK(curve.points[2].runs == 4);
  CHECK(curve.points[2].cost ==
        doctest::Approx(2 / 0.0025).epsilon(rounding));  // HOA2: two per step

  const EquipartitionFit fit = equipartition(all)[1];
  REQUIRE(fit.axes[0]);
  CHECK(fit.axes[0]->intercept.value == doctest::Approx(0.5).epsilon(rounding));
  CHECK(fit.axes[0]->slope.value == doctest::Approx(-2e5).epsilon(rounding));
  // Four points with errors of √(10/12) K each, known at h² = 1, 4, 6.25 and 9·10⁻⁶.
  CHECK(fit.axes[0]->intercept.error ==
        doctest::Approx(std::sqrt(10.0 / 12 * (1 + 16 + 39.0625 + 81) /
                                  (4 * (1 + 16 + 39.0625 + 81) - 20.25 * 20.25)))
            .epsilon(rounding));
  CHECK(!fit.axes[1]);  // no such degree of freedom
  CHECK(!fit.configurational[0]);
  REQUIRE(fit.configurational[1]);
  CHECK(fit.configurational[1]->intercept.value == doctest::Approx(-0.25).epsilon(rounding));
  CHECK(fit.configurational[1]->slope.value == doctest::Approx(3e5).epsilon(rounding));
}

TEST_CASE("a run that blew up is not used for temperatures") {
  AdviserPoint one = point(0.001, false);
  one.runs[3].failure = "it blew up";
  one.runs[3].temperatures.rotation[0] = 1e6;
  const EfficiencyPoint p = efficiency_point(advice_of({}).candidates[1], one);
  CHECK(!p.stable);
  REQUIRE(p.excess[0]);
  CHECK(p.excess[0]->value == doctest::Approx(0.5 - 0.2 - 2.0 / 3).epsilon(rounding));
}
