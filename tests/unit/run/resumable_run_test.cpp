// SPDX-License-Identifier: MIT
#include "run/adviser/resumable_run.hpp"

#include <doctest/doctest.h>

#include "polhode/integrate/scheme_text.hpp"

using namespace polhode;

// Wherever a run is suspended, the rest equals that of an uninterrupted run bit for bit: energies,
// the random signs of configurational temperatures, and the last sample, which here is between two
// intervals.
TEST_CASE("a suspended and resumed run gives the results of an uninterrupted one") {
  const Config config = parse_config(R"([system]
molecules = [{ model = "argon", count = 32 }]
density = "0.9 g/cm3"
temperature = "150 K"
[forces]
cutoff = "0.65 nm"
)",
                                     "this test");
  const ResumableRun start{build_system(config), 7};
  TrajectorySettings settings{
      .scheme = scheme_of("hoa2"), .step = 0.005, .sample = 0.01, .configurational_sample = 0.02};
  settings.length = 121 * settings.step;
  ResumableRun whole = start;
  const Outcome expected = advance_run(whole, settings, {});
  REQUIRE(expected.failure.empty());
  REQUIRE(expected.configurational);
  CHECK((*expected.configurational)[0] > 0);
  CHECK(whole.state->statistics.energies.samples == 61);  // without the last one, between two

  ResumableRun left = start;
  Outcome run;
  for (const std::size_t steps : {std::size_t{13}, std::size_t{40}, std::size_t{121}}) {
    settings.length = static_cast<double>(steps) * settings.step;
    run = advance_run(left, settings, {});
    CHECK(left.state->steps == steps);
  }
  CHECK(left.state->statistics.energies.samples == whole.state->statistics.energies.samples);
  CHECK(run.ratio == expected.ratio);
  CHECK(run.drift == expected.drift);
  CHECK(run.temperatures.translation == expected.temperatures.translation);
  CHECK(run.configurational == expected.configurational);
}
