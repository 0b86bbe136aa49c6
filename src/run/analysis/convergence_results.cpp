// SPDX-License-Identifier: MIT
#include "convergence_results.hpp"

#include <fmt/core.h>

#include <cmath>

#include "curves.hpp"
#include "io/settings/output_units.hpp"

namespace polhode {
namespace {

/// The unit of the second significant digit of a positive number.
double second_digit(double x) { return std::pow(10, std::floor(std::log10(x)) - 1); }

/// A number rounded up to two digits; a relative excess of 1e-9 is round-off and is ignored.
double rounded_up(double x) {
  return x > 0 ? second_digit(x) * std::ceil(x / second_digit(x) - 1e-8) : x;
}

double rounded_down(double x) {
  return x > 0 ? second_digit(x) * std::floor(x / second_digit(x) + 1e-8) : x;
}

}  // namespace

std::string not_converged(const Convergence& c, const RelaxationName& relaxation) {
  const std::string longer = fmt::format("a run of at least {:g} {}", rounded_up(c.needed), c.unit);
  switch (c.obstacle) {
    case Obstacle::slope_changes:
      return fmt::format(
          "not converged: the slope of the mean-square displacement differs between the two halves "
          "of the fit, which ends at {:.2g} ps; use a longer window, a fit from a longer lag, or "
          "{}",
          c.relaxation, longer);
    case Obstacle::integral_changes:
      return fmt::format(
          "not converged: the integrals up to half of the window and up to {:.2g} ps differ; use a "
          "longer window, or {}",
          c.relaxation, longer);
    case Obstacle::interval:
      return fmt::format(
          "not converged: the interval between frames is too long for an integral over velocities; "
          "write frames every {:g} fs or more often",
          rounded_down(units::fs_per_ps * c.interval));
    case Obstacle::none:
    case Obstacle::length:
    case Obstacle::no_error:
    case Obstacle::still_moving:
      break;
  }
  // Without the margin, round-off would decide whether two intervals are enough.
  const double window = rounded_down(c.length / windows_of_lags);
  const bool shorter =
      relaxation.window && c.obstacle == Obstacle::length && window * (1 + 1e-6) >= c.min_window;
  return fmt::format("not converged: length {:.3g} {}, {} {:.2g} {}; {} is needed{}", c.length,
                     c.unit, relaxation.text, c.relaxation, c.unit, longer,
                     shorter ? fmt::format(", or a window of at most {:g} ps", window) : "");
}

Quantities converging(const SeriesEstimate& e, const Convergence& c,
                      const RelaxationName& relaxation) {
  if (c.converged())
    return {{"value", "", e.value}, {"error", "", known_error(e)}, {"converged", "", true}};
  Quantities list = {{"value", "", {}},
                     {"error", "", {}},
                     {"converged", "", false},
                     {"unconverged_estimate", "", e.value},
                     {"reason", "", not_converged(c, relaxation)},
                     {"length", c.unit, c.length},
                     {"relaxation", c.unit, c.relaxation},
                     {"needed", c.unit, c.needed}};
  if (c.obstacle == Obstacle::interval) list.push_back({"needed_interval", "ps", c.interval});
  return list;
}

}  // namespace polhode
