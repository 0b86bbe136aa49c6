// SPDX-License-Identifier: MIT
// A model of R as a function of the time step, from runs at a few time steps. All steps use the
// same initial configurations.
#pragma once

#include <vector>

#include "polhode/math/fit.hpp"

namespace polhode {

/// Values of R at a given step, one for each initial configuration.
struct StepPoint {
  double step = 0;             ///< time step [ps]
  std::vector<double> ratios;  ///< R for each initial configuration
};

/// A model of R as a function of the step h: R(h) = a hᵖ exp(c h²), where p is the order of the
/// scheme. For small steps the model is the power law a hᵖ with the first correction, a hᵖ (1 + c
/// h²). The exponential form is always positive. In this form log R − p log h is linear in h². Two
/// steps with a ratio of about 1.3 suffice to fit the model near these steps. The model is not
/// meant for extrapolation.
///
/// Two runs with different steps from the same initial configuration are not independent: they
/// sample the same part of the trajectory. Therefore a separate line is fitted for each initial
/// configuration, and the scatter of these lines gives the uncertainty of the mean line. The runs
/// at each step give the scatter of a single run.
class StepModel {
 public:
  /// @param order   order p of the scheme; 0 (unknown) is treated as 2
  /// @param points  at least one point; each point has at least two initial configurations, in the
  ///   same order
  StepModel(int order, const std::vector<StepPoint>& points);

  /// The mean of log R over initial configurations at a given step, with its standard error.
  Estimate log_ratio(double step) const;

  /// The prediction bound: the value below which R of a new run at the step lies with a given
  /// probability. The bound is computed from Student's t distribution with n − 1 degrees of
  /// freedom, for n initial configurations.
  double bound(double step, double probability) const;

  /// The local exponent d log R/d log h = p + 2 c h².
  double exponent(double step) const;

  /// The largest step, up to `limit`, whose prediction bound is at most `ratio`.
  double max_step(double ratio, double probability, double limit) const;

 private:
  struct Line {
    double at_mean = 0, slope = 0;  ///< log R − p log h at the mean of h², and its slope in h²
  };
  double value(const Line& line, double step) const;

  int order_;
  double mean_square_ = 0;  ///< mean of h² over the steps
  std::vector<Line> lines_;
  double scatter_ = 0;
};

}  // namespace polhode
