// SPDX-License-Identifier: MIT
// Curves over state points that are made up here: maxima of the density, and slopes.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "polhode/base/units.hpp"
#include "polhode/math/random.hpp"
#include "polhode/run/properties/measure.hpp"
#include "run/properties/property.hpp"

using namespace polhode;

namespace {

constexpr double bar = units::avogadro * 1e-25;  // [kJ/mol/nm³]
constexpr double error = 0.2;                    // of densities [kg/m³]

SeriesEstimate known(double value, double standard_error) {
  return {value, standard_error, Known::yes, 35};
}

/// A point whose properties from fluctuations are those given.
MeasuredPoint point(double T, double p, double density, double enthalpy,
                    const std::vector<std::pair<const char*, SeriesEstimate>>& properties) {
  MeasuredPoint found{.at = {T, p * bar}};
  found.density = known(density, error);
  found.enthalpy = known(enthalpy, 0.01);
  for (const auto& [name, value] : properties)
    found.properties.push_back({.request = {&property(name)}, .value = value});
  return found;
}

/// Densities at 1 bar, with the property that asks for their maximum.
std::vector<MeasuredPoint> densities(const std::vector<double>& temperatures,
                                     const std::function<double(double)>& density) {
  std::vector<MeasuredPoint> points;
  for (const double T : temperatures)
    points.push_back(point(T, 1, density(T), -40, {{"density", known(density(T), error)}}));
  return points;
}

constexpr double top = 277;  // [K]
double parabola(double T) { return 999 - 0.01 * std::pow(T - top, 2); }
double cubic(double T) { return parabola(T) + 5e-5 * std::pow(T - top, 3); }

}  // namespace

TEST_CASE("the maximum of a parabola or a cubic is found exactly") {
  const StateCurves three = state_curves(densities({300, 260, 280}, parabola));
  REQUIRE(three.maxima.size() == 1);
  CHECK(three.maxima[0].temperature.value == doctest::Approx(top).epsilon(1e-10));
  CHECK(three.maxima[0].density.value == doctest::Approx(999).epsilon(1e-10));
  CHECK(three.maxima[0].fit.degree == 2);
  CHECK(three.maxima[0].fit.degrees_of_freedom() == 0);
  CHECK(three.maxima[0].fit.text() == "quadratic polynomial through the points");
  CHECK(state_curves(densities({260, 270, 280, 300}, parabola)).maxima[0].fit.degree == 2);
  const StateCurves five = state_curves(densities({250, 265, 280, 295, 310}, cubic));
  CHECK(five.maxima[0].fit.degree == 3);
  CHECK(five.maxima[0].temperature.value == doctest::Approx(top).epsilon(1e-10));
  CHECK(five.maxima[0].fit.chi_squared < 1e-10);
  // With the cubic term of the other sign, too.
  const auto mirrored = [](double T) { return cubic(2 * top - T); };
  CHECK(state_curves(densities({250, 265, 280, 295, 310}, mirrored)).maxima[0].temperature.value ==
        doctest::Approx(top).epsilon(1e-10));
  CHECK(three.slopes.empty());  // no such property was requested
}

TEST_CASE("the error of the temperature of maximum density is that of its scatter") {
  const std::vector<double> temperatures = {250, 262, 274, 286, 298, 310};
  Random random(11);
  constexpr int repetitions = 2000;
  double sum = 0, squares = 0, stated = 0, chi = 0;
  for (int k = 0; k < repetitions; ++k) {
    const StateCurves found = state_curves(
        densities(temperatures, [&](double T) { return cubic(T) + error * random.normal(); }));
    const DensityMaximum& m = found.maxima.at(0);
    REQUIRE(m.obstacle.empty());
    sum += m.temperature.value - top;
    squares += std::pow(m.temperature.value - top, 2);
    stated += m.temperature.error / repetitions;
    chi += m.fit.chi_squared / repetitions;
  }
  const double mean = sum / repetitions, scatter = std::sqrt(squares / repetitions - mean * mean);
  // The scatter is known to 1/√4000 = 1.6 %; 4 times as much, and 2 % for terms beyond the first.
  CHECK(scatter == doctest::Approx(stated).epsilon(0.085));
  CHECK(std::abs(mean) < 4 * scatter / std::sqrt(repetitions) + 0.02 * scatter);
  // χ² of two degrees of freedom has the mean 2 and the variance 4.
  CHECK(std::abs(chi - 2) < 4 * 2 / std::sqrt(repetitions));
}

TEST_CASE("a maximum outside of the points, or without certainty, is not stated") {
  const auto obstacle = [](const std::vector<MeasuredPoint>& points) {
    const StateCurves found = state_curves(points);
    REQUIRE(found.maxima.size() == 1);
    CHECK(found.maxima[0].temperature.known != Known::yes);
    return found.maxima[0].obstacle;
  };
  CHECK(obstacle(densities({280, 290, 300}, parabola)).find("measure at lower temperatures") !=
        std::string::npos);
  CHECK(obstacle(densities({240, 250, 260, 265, 270}, cubic))
            .find("between 240 K and 270 K; measure at higher") != std::string::npos);
  CHECK(obstacle(densities({260, 280, 300}, [](double T) {
          return 1000 + 0.01 * std::pow(T - 280, 2);
        })).find("no maximum") != std::string::npos);
  CHECK(obstacle(densities({276, 277, 278}, parabola)).find("not determined") != std::string::npos);
  CHECK(state_curves(densities({260, 280}, parabola)).maxima.empty());
  CHECK(state_curves(densities({260, 280, 280}, parabola)).maxima.empty());
}

TEST_CASE("slopes are those of the thermodynamic derivatives") {
  // ρ = ρ₀ exp(−α (T − 300)) is nearly quadratic: α²ΔT²/6 of the slope is 2e-6 of it.
  constexpr double alpha = 2.5e-4, cp = 80, kappa = 4.5e-5;
  std::vector<MeasuredPoint> points;
  for (const double T : {290.0, 300.0, 310.0})
    points.push_back(point(T, 1, 997 * std::exp(-alpha * (T - 300)), -40 + cp * 1e-3 * (T - 300),
                           {{"expansivity", known(260, 5)}, {"heat-capacity", known(78, 1)}}));
  const StateCurves temperatures = state_curves(points);
  REQUIRE(temperatures.slopes.size() == 2);  // at the point in the middle
  CHECK(temperatures.maxima.empty());        // the density was not requested
  const SlopeValue &expansivity = temperatures.slopes[0], &heat = temperatures.slopes[1];
  CHECK(std::string(expansivity.property->name) == "expansivity");
  CHECK(expansivity.at.temperature == 300);
  CHECK(expansivity.slope.value == doctest::Approx(alpha * 1e6).epsilon(1e-5));
  // The slope through three points is that of the outer ones: √2 ε/(20 K).
  const double slope_error = std::sqrt(2.0) * error / 20 / 997 * 1e6;
  CHECK(expansivity.slope.error == doctest::Approx(slope_error).epsilon(1e-5));
  CHECK(expansivity.deviation ==
        doctest::Approx((250 - 260) / std::hypot(slope_error, 5)).epsilon(1e-3));
  CHECK(heat.slope.value == doctest::Approx(cp).epsilon(1e-10));
  CHECK(heat.slope.error == doctest::Approx(std::sqrt(2.0) * 0.01 / 20 * 1000).epsilon(1e-10));
  CHECK(heat.fluctuation.value == 78);
  std::vector<MeasuredPoint> pressures;
  for (const double p : {1.0, 501.0, 1001.0})
    pressures.push_back(
        point(300, p, 997 * (1 + kappa * p), -40, {{"compressibility", known(45, 1)}}));
  const StateCurves along_pressure = state_curves(pressures);
  REQUIRE(along_pressure.slopes.size() == 1);
  CHECK(along_pressure.slopes[0].slope.value ==
        doctest::Approx(kappa * 1e6 / (1 + kappa * 501)).epsilon(1e-9));
}

TEST_CASE("each pressure has its own curve, and points without averages have none") {
  std::vector<MeasuredPoint> points = densities({260, 280, 300}, parabola);
  for (const MeasuredPoint& other : densities({260, 280, 300}, cubic)) {
    points.push_back(other);
    points.back().at.pressure *= 1000;
  }
  CHECK(state_curves(points).maxima.size() == 2);
  points[0].density = {std::nan("")};
  CHECK(state_curves(points).maxima.size() == 1);
  points[4].at.density = 600;  // at constant volume
  CHECK(state_curves(points).maxima.empty());
}

TEST_CASE("points that deviate from the polynomial by more than their errors are told") {
  const std::vector<double> temperatures = {250, 262, 274, 286, 298, 310};
  const auto wavy = [](double T) { return cubic(T) + (std::fmod(T - 250, 24) < 1 ? 1 : -1); };
  const StateFit misfit = state_curves(densities(temperatures, wavy)).maxima[0].fit;
  CHECK(misfit.misfit());
  CHECK(misfit.text().find("the points deviate") != std::string::npos);
  CHECK(!state_curves(densities(temperatures, cubic)).maxima[0].fit.misfit());
}
