// SPDX-License-Identifier: MIT
// Chooses which steps of a scheme to measure, so that the largest step that meets a bound is found
// with few runs and without jumping far beyond the stability limit.
#pragma once

#include <optional>
#include <vector>

#include "polhode/run/adviser/criterion.hpp"
#include "polhode/run/adviser/step_model.hpp"

namespace polhode {

struct StepSearch {
  Criterion criterion;
  int order = 2;     ///< of the scheme; 0 if unknown
  double first = 0;  ///< a step that is certainly stable [ps]
};

/// The next step to measure [ps], or nothing when enough is known. Steps grow by at most a factor
/// of `max_growth` over the largest usable one, so that, at worst, a single run blows up at the
/// stability limit; if a step beyond the limit is known, by less than half of the distance to it.
///
/// For R, the search aims at the step where R equals the bound, first by the scheme's order and
/// then by interpolation, and ends with points at 1, 0.9 and 0.8 of that step: R must stay below
/// the bound in nearly all runs, so the final step is smaller. For an energy drift or a bias, which
/// noise hides at small steps, the steps form a ladder up to where the bound is violated.
/// @param points  so far, ordered by step
std::optional<double> next_step(const StepSearch& search, const std::vector<AdviserPoint>& points);

inline constexpr double max_growth = 1.6;

/// Upper estimate of the steps that can meet the bound [ps]: for R the step where it equals the
/// bound, extrapolated with the scheme's order; otherwise, or without a usable point, the stability
/// limit as far as it is known. Infinite if nothing is known.
double max_expected_step(const StepSearch& search, const std::vector<AdviserPoint>& points);

/// Whether runs with that step enter the answer, rather than only guide the search for it.
bool decides(const StepSearch& search, const std::vector<AdviserPoint>& points, double step);

/// Result of the search: the largest step that is expected to meet the bound [ps], 0 if there is
/// none, and for R the model behind it.
struct FoundStep {
  double step = 0;
  std::optional<StepModel> model;
};
FoundStep found_step(const StepSearch& search, const std::vector<AdviserPoint>& points);

/// Relative to the required value: a step whose bound is below `max_caution` is shorter than
/// necessary, by a tenth or more at second order, and is lengthened until the bound would be `aim`.
inline constexpr double max_caution = 0.8, aim = 0.9;

/// A longer step instead of one whose runs met the requirement with a wide margin, by
/// R ∝ h^exponent, at most 1.25 times as long and at most half of the way, on a logarithmic scale,
/// to a step that is known to be too long. Nothing if the ratio reached is at least `max_caution`,
/// or if the gain is below 2 %.
/// @param reached   the bound of the runs divided by the required value
/// @param too_long  the shortest step known to be too long; infinite if none is [ps]
std::optional<double> lengthened(double step, double reached, double exponent, double too_long);

/// The factor by which a step is shortened after confirming runs that had no energy drift but
/// exceeded the bound, between 0.6 and 0.97.
/// @param whole_set  the number of runs of a set that was not ended early
/// @param part       of the whole length that they covered
double shortening(const Criterion& criterion, const std::vector<Outcome>& runs,
                  std::size_t whole_set, double part, double exponent);

/// The next shorter step with three significant digits.
double three_digits(double step);

}  // namespace polhode
