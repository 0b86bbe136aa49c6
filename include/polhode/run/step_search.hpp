// SPDX-License-Identifier: MIT
// Which steps of a scheme to measure, so that the longest one that keeps a bound is found with few
// runs and without a leap beyond the end of stability.
#pragma once

#include <optional>
#include <vector>

#include "polhode/run/criterion.hpp"
#include "polhode/run/step_model.hpp"

namespace polhode {

struct StepSearch {
  Criterion criterion;
  int order = 2;     ///< of the scheme; 0 if unknown
  double first = 0;  ///< a step that is surely stable [ps]
};

/// The next step to measure [ps], or nothing when enough is known. Steps grow by at most
/// `most_growth` from the longest that is usable, so that the end of stability is met in a run that
/// blows up at worst; where one is known to lie beyond it, by less than half of the way there.
///
/// For R the steps aim at where it equals the bound, by the scheme's order and then by what was
/// measured, and end with points at 1, 0.9 and 0.8 of that step: R has to stay below the bound in
/// nearly all runs, so the step wanted is shorter. For a drift or a bias, which noise hides at
/// short steps, they are a ladder until the bound is broken.
/// @param points  so far, by growing step
std::optional<double> next_step(const StepSearch& search, const std::vector<AdviserPoint>& points);

inline constexpr double most_growth = 1.6;

/// No longer step is expected to keep the bound [ps]: for R where it meets the bound, by the law of
/// the order beyond the points; else, and without a usable point, the end of stability as far as it
/// is known. Infinite if nothing is known.
double longest_expected(const StepSearch& search, const std::vector<AdviserPoint>& points);

/// Whether runs with that step decide about the answer; others only show the way to it.
bool decides(const StepSearch& search, const std::vector<AdviserPoint>& points, double step);

/// What the points say: the longest step that is expected to keep the bound [ps], 0 if there is
/// none, and for R the model behind it.
struct FoundStep {
  double step = 0;
  std::optional<StepModel> model;
};
FoundStep found_step(const StepSearch& search, const std::vector<AdviserPoint>& points);

/// Of what was asked: a step whose bound is below the first of them is longer than it need be by a
/// tenth and more at second order, and is lengthened to where the bound would be the second.
inline constexpr double most_caution = 0.8, aim = 0.9;

/// A longer step in place of one whose runs kept the bound with room to spare, by R ∝ h^exponent
/// and at most 1.25 times as long; no further than half of the way to where a step is known to be
/// too long. Nothing where there is less than `most_caution` to gain from, or the gain is below 2
/// %.
/// @param reached   the bound of the runs over what was asked
/// @param too_long  the shortest step known not to do; infinite if none is [ps]
std::optional<double> lengthened(double step, double reached, double exponent, double too_long);

/// The next shorter step with three significant digits.
double three_digits(double step);

}  // namespace polhode
