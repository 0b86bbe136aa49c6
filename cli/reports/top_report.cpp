// SPDX-License-Identifier: MIT
#include "top_report.hpp"

#include <fmt/core.h>

namespace polhode::cli {

void print_top(const TopTrajectory& top) {
  fmt::print(
      "step {:.6g}: the top initially turns by {:.3g} per step; errors of energy and |L| are "
      "relative,\nattitude is the angle [rad] from the closed form\n\n",
      top.step, top.angle);
  fmt::print("{:>10}  {:^32}  {:^29}  {:^29}\n", "", "exact, closed form",
             "exact, series step by step", "NO_SQUISH step by step");
  fmt::print("{:>10} {:>10} {:>10} {:>10}  {:>9} {:>9} {:>9}  {:>9} {:>9} {:>9}\n", "t", "L1", "L2",
             "L3", "energy", "|L|", "attitude", "energy", "|L|", "attitude");
  for (const TopSample& line : top.samples)
    fmt::print(
        "{:10.4g} {:10.5g} {:10.5g} {:10.5g}  {:9.1e} {:9.1e} {:9.1e}  {:9.1e} {:9.1e} {:9.1e}\n",
        line.t, line.exact.L.x, line.exact.L.y, line.exact.L.z, line.series.energy_error,
        line.series.momentum_error, line.series.angle, line.no_squish.energy_error,
        line.no_squish.momentum_error, line.no_squish.angle);
}

}  // namespace polhode::cli
