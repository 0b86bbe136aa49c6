// SPDX-License-Identifier: MIT
// Results of a study: the cost of each scheme at a given accuracy, the R at which a scheme becomes
// cheaper than another, and the end of the curve of each scheme.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "polhode/run/study/study.hpp"

namespace polhode {

/// The smallest cost at which a scheme keeps R at or below a given value.
struct CostAtRatio {
  double cost = 0;                ///< force evaluations per ps
  double error = 0;               ///< error of the cost, from the errors of R at the neighbouring
                                  ///< points
  double degrees_of_freedom = 0;  ///< degrees of freedom of the cost error
  double step = 0;                ///< time step [ps]
  double evaluations = 0;         ///< number of force evaluations per step
  double exponent = 0;            ///< local order d log R / d log h
  bool extrapolated = false;      ///< whether R is below the smallest measured R, so that the cost
                                  ///< is extrapolated with the order of the scheme
  bool at_max_step = false;       ///< whether the largest step of the curve is used, because R
                                  ///< stays below the given value
};

struct Guideline {
  double ratio = 0;                               ///< given value of R
  std::vector<std::optional<CostAtRatio>> costs;  ///< cost of each scheme; empty if the scheme
                                                  ///< cannot reach the given R without energy drift
  std::optional<std::size_t> best;                ///< index of the cheapest scheme
};

/// The curve of a scheme: points ordered by step.
struct Curve {
  std::string scheme;
  std::vector<EfficiencyPoint> points;
  std::size_t usable = 0;  ///< number of points before the end
};

/// The curves of a study, in the order in which schemes first occur in the points.
std::vector<Curve> curves(const std::vector<EfficiencyPoint>& points);

/// The cost at a given R, by interpolation of log h over log R between neighbouring usable points.
/// If even the largest usable step has a smaller R than the given R, the result is the cost of the
/// largest step.
std::optional<CostAtRatio> cost_at(const Curve& curve, double ratio);

std::vector<Guideline> guidelines(const std::vector<Curve>& curves,
                                  const std::vector<double>& ratios);

/// The R below which a scheme is cheaper than another scheme.
struct Crossing {
  Estimate ratio;
  double degrees_of_freedom = 0;  ///< degrees of freedom of the error of R
};

/// The value of R below which `finer` is cheaper than `coarser`, if the two curves cross within the
/// measured range of both.
std::optional<Crossing> crossover(const Curve& finer, const Curve& coarser);

}  // namespace polhode
