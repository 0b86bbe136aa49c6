// SPDX-License-Identifier: MIT
// 64 waters for a picosecond, with the exact free rotor and HOA2.
#include <cstdio>

#include "polhode/polhode.hpp"

constexpr auto run_file = R"(
system = { molecules = [{ model = "tip4p", count = 64 }], density = "1 g/cm3", temperature = "298 K" }
forces = { cutoff = "0.6 nm" }
integrator = { scheme = "hoa2", step = "4 fs" }
run = { equilibrate = "1 ps" }
)";

int main() {
  polhode::Simulation simulation(polhode::parse_config(run_file, "run_file"));
  simulation.step(250);  // equilibrates before the first step
  const polhode::RunSummary run = simulation.summary();
  std::printf("%g ps: R = %.2g %%, %llu force evaluations, molecule 1 at x = %.3f nm\n", run.length,
              100 * run.ratio.value, static_cast<unsigned long long>(run.force_evaluations),
              simulation.state().q[0].x);
}
