// SPDX-License-Identifier: MIT
// Chooses the steps of a scheme to measure. The search finds the largest step that meets a bound
// with few runs, and does not try steps far beyond the stability limit.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "polhode/run/adviser/criterion.hpp"
#include "polhode/run/adviser/step_model.hpp"

namespace polhode {

/// Checks that the system has forces.
/// @param frequency  frequency of the fastest motions [1/ps], from einstein_frequency()
/// @param source     file of the initial configuration's run, for error messages
/// @throws Error  if the forces are only round-off
void check_forces(double frequency, const std::string& source);

/// Checks the length of the test runs.
/// @param length  length of the runs [ps]
/// @param first   first step to be tried [ps]
/// @throws Error  if a run has less than ten steps
void check_length(double length, double first, std::string_view scheme);

struct StepSearch {
  Criterion criterion;
  int order = 2;     ///< order of the scheme; 0 if unknown
  double first = 0;  ///< step that is certainly stable [ps]
};

/// The next step to measure [ps]; empty when the search is complete. Steps grow by at most a factor
/// of `max_growth` over the largest usable step. With this limit, a single run blows up at the
/// stability limit in the worst case. If a step beyond the stability limit is known, steps grow by
/// less than half of the distance to that step.
///
/// For R, the search finds the step at which R equals the bound, first from the order of the scheme
/// and then by interpolation. The search ends with points at 1, 0.9 and 0.8 times the step at which
/// R equals the bound. The final step is smaller, because R must stay below the bound in nearly all
/// runs. An energy drift or a bias is hidden by noise at small steps. For energy drift and bias,
/// the steps form a geometric series that ends where the bound is violated.
/// @param points  points measured so far, ordered by step
std::optional<double> next_step(const StepSearch& search, const std::vector<AdviserPoint>& points);

inline constexpr double max_growth = 1.6;

/// An upper estimate of the longest step that can meet the bound [ps]. For R the estimate is the
/// step at which R equals the bound, extrapolated with the order of the scheme. For other criteria,
/// or without a usable point, the estimate is the stability limit if known. The estimate is
/// infinite if nothing is known.
double max_expected_step(const StepSearch& search, const std::vector<AdviserPoint>& points);

/// Whether runs at a step contribute to the choice of the final step, rather than only guiding the
/// search.
bool decides(const StepSearch& search, const std::vector<AdviserPoint>& points, double step);

/// The result of the search: the largest step that is expected to meet the bound [ps], or 0 if
/// there is none. For R, the result also has the fitted model.
struct FoundStep {
  double step = 0;
  std::optional<StepModel> model;
};
FoundStep found_step(const StepSearch& search, const std::vector<AdviserPoint>& points);

/// Thresholds for the prediction bound at a step, as a fraction of the required value. A step whose
/// prediction bound is below `max_caution` is shorter than necessary, by at least 10 % at second
/// order. Such a step is lengthened so that the expected prediction bound is `aim`.
inline constexpr double max_caution = 0.8, aim = 0.9;

/// A longer step, according to R ∝ h^exponent. The longer step replaces a step if the runs at that
/// step met the requirement by a wide margin. The longer step is at most 1.25 times as long. The
/// longer step is also at most halfway, on a logarithmic scale, to a step that is known to be too
/// long. The result is empty if `reached` is at least `max_caution`, or if the gain is below 2 %.
/// @param reached   bound of the runs divided by the required value
/// @param too_long  shortest step known to be too long [ps]; infinite if there is none
std::optional<double> lengthened(double step, double reached, double exponent, double too_long);

/// The factor, from 0.6 to 0.97, by which a step is shortened after confirming runs that exceeded
/// the bound but had no energy drift.
/// @param whole_set  number of runs of a complete set
/// @param part       fraction of the whole length that the runs covered
double shortening(const Criterion& criterion, const std::vector<Outcome>& runs,
                  std::size_t whole_set, double part, double exponent);

/// A step rounded down to three significant digits.
double three_digits(double step);

}  // namespace polhode
