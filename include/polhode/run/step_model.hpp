// SPDX-License-Identifier: MIT
// R of one scheme as a function of its step, from runs of the same starts with a few steps.
#pragma once

#include <vector>

#include "polhode/math/fit.hpp"

namespace polhode {

/// R of one run from each start, all with the same step.
struct StepPoint {
  double step = 0;             ///< [ps]
  std::vector<double> ratios;  ///< R, by start
};

/// R(h) = a hᵖ exp(c h²), p the scheme's order: the law of small steps with its first correction, a
/// hᵖ (1 + c h²), in a form that stays above 0 and is a line in log R − p log h against h². Steps a
/// third apart suffice to fix it next to them; it is not meant for far ones.
///
/// Runs from one start with two steps are not independent: they see the same stretch of the liquid.
/// So each start has a line of its own, and what the mean line does not know is read from their
/// scatter; how a single run scatters is read from the runs themselves, step by step.
class StepModel {
 public:
  /// @param order   p; 0, unknown, is taken as 2
  /// @param points  at least one, with the same starts in the same order, at least two
  StepModel(int order, const std::vector<StepPoint>& points);

  /// log R at a step, the mean over starts, with its standard error.
  Estimate log_ratio(double step) const;

  /// What R of a fresh run at that step stays below with this probability: Student's t with as many
  /// degrees of freedom as there are starts less one.
  double bound(double step, double probability) const;

  /// d log R/d log h = p + 2 c h².
  double exponent(double step) const;

  /// The longest step, up to `longest`, with a bound of at most that R.
  double longest_step(double ratio, double probability, double longest) const;

  double scatter() const { return scatter_; }  ///< of log R of a single run

 private:
  struct Line {
    double at_mean = 0, slope = 0;  ///< of log R − p log h at the mean h², and against h²
  };
  double value(const Line& line, double step) const;

  int order_;
  double mean_square_ = 0;  ///< of h
  std::vector<Line> lines_;
  double scatter_ = 0;
};

}  // namespace polhode
