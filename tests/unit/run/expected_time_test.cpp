// SPDX-License-Identifier: MIT
// The expected time of a measurement, and the warnings if it is too long.
#include "run/properties/expected_time.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "../errors.hpp"
#include "run/properties/property.hpp"

using namespace polhode;

namespace {

constexpr double year = 365.25 * 86400;

/// A density of 1000 ± 1 kg/m3 after 2e6 steps of averages, of which 1000 take a second.
constexpr WorkDone done{{{2e6, 5e6}}, 1e-3};

MeasuredProperty found(const char* name, double value, double error, double requested) {
  return {.request = {&property(name), requested, true}, .value = {value, error, Known::yes, 35}};
}

}  // namespace

TEST_CASE("an error that is n times smaller needs n² times the length") {
  const MeasuredProperty density = found("density", 1000, 1, 1e-4);
  // 100 times the 2000 s so far, of which one is done.
  CHECK(expected_time(density, density.requested_error(), done).value() ==
        doctest::Approx(99 * 2000.0));
  CHECK(reachable_error(density, 99 * 2000.0, done) == doctest::Approx(0.1));
  CHECK(expected_time(found("density", 1000, 1, 0.01), 10, done).value() == 0);
  // Dynamics have their own length.
  const MeasuredProperty viscosity = found("viscosity", 1, 0.1, 0.05);
  CHECK(expected_time(viscosity, 0.05, done).value() == doctest::Approx(3 * 5000.0));
  // Averages and dynamics follow each other; several properties of a kind use the same length.
  const std::vector both = {density, found("enthalpy", -40, 0.04, 1e-3), viscosity};
  CHECK(expected_time(both, 1, done).value() == doctest::Approx(99 * 2000.0 + 3 * 5000.0));
  // One of four parts needs twice the error.
  CHECK(expected_time(std::vector{density}, 2, done).value() == doctest::Approx(24 * 2000.0));
}

TEST_CASE("no time is expected where the error or the speed is not known") {
  MeasuredProperty m = found("density", 1000, 1, 1e-4);
  CHECK(!expected_time(m, 0.1, {2e6, 0, 0}));
  m.obstacle = "the slope still changes";
  CHECK(!expected_time(m, 0.1, done));
  m = found("density", 1000, 1, 1e-4);
  m.value.known = Known::too_short;
  CHECK(!expected_time(m, 0.1, done));
  CHECK(!expected_time(found("second-virial-coefficient", -400, 10, 1e-4), 0.1, done));
  CHECK(!expected_time(std::vector{m}, 1, done));
}

TEST_CASE("a time beyond the limit is a warning, with the error that is reachable") {
  const std::vector values = {found("density", 1000, 1, 1e-4), found("viscosity", 1, 0.1, 0.05)};
  const TimeAllowed limit{15'000, true};
  const std::vector<std::string> warnings = time_warnings(values, 1, done, limit);
  REQUIRE(warnings.size() == 1);  // the viscosity needs 15,000 s
  CAPTURE(warnings[0]);
  // 2000 s have given 1 kg/m3: 17,000 s give 0.343, which is 0.036 % with the margin.
  for (const char* part : {"density with an error of 0.01 % needs about 2 days",
                           "in 4 h, the time limit, an error of 0.036 % is reachable"})
    CHECK(warnings[0].find(part) != std::string::npos);
  CHECK(time_warnings(values, 1, done, {usual_time}).empty());
}

TEST_CASE("a time beyond a year is an error without a time limit") {
  // The time is (10 f)² 2000 s for an error of 1e-4/f.
  const auto with_time = [](double seconds) {
    return std::vector{found("density", 1000, 1, 1e-3 / std::sqrt(seconds / 2000 + 1))};
  };
  check_error([&] { time_warnings(with_time(1.01 * year), 1, done, {usual_time}); },
              {"density with an error of", "needs about 369 days", "less than a year",
               "ask for an error of 0.0029 %", "time limit"});
  CHECK(time_warnings(with_time(0.99 * year), 1, done, {usual_time}).size() == 1);
  CHECK(time_warnings(with_time(1000 * year), 1, done, {3600, true}).size() == 1);
  MeasuredProperty absolute = found("density", 1000, 1, 1e-6);
  absolute.request.relative = false;
  check_error([&] { time_warnings(std::vector{absolute}, 1, done, {usual_time}); },
              {"an error of 1e-06 kg/m3"});
}

TEST_CASE("durations have a readable unit") {
  CHECK(duration_text(40) == "40 s");
  CHECK(duration_text(600) == "10 min");
  CHECK(duration_text(3 * 3600.0) == "3 h");
  CHECK(duration_text(50 * 86400.0) == "50 days");
  CHECK(duration_text(2.5 * year) == "2.5 years");
  CHECK(duration_text(1e6 * year) == "1e+06 years");
}
