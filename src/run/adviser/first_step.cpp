// SPDX-License-Identifier: MIT
#include "first_step.hpp"

#include <fmt/format.h>

#include "io/settings/output_units.hpp"
#include "polhode/base/error.hpp"

namespace polhode {

void check_forces(double frequency, const std::string& source) {
  // The Einstein frequency exceeds 0.1 per ps in any liquid and in most gases. If the frequency is
  // far lower, the forces are only round-off errors.
  constexpr double min_frequency = 1e-6;
  if (!(frequency > min_frequency))
    throw Error(
        "the forces in the initial configuration are nearly zero, as on a perfect lattice, so the "
        "first step cannot be estimated; equilibrate first, for example with equilibrate = \"5 "
        "ps\" in [run]",
        source);
}

void check_length(double length, double first, std::string_view scheme) {
  if (length < 10 * first)
    throw Error(
        fmt::format("runs of {:g} fs are too short for advice; a run must have at least ten steps "
                    "of {:.3g} fs, the first time step tried with the scheme {}: use longer runs",
                    units::fs_per_ps * length, units::fs_per_ps * first, scheme));
}

}  // namespace polhode
