// SPDX-License-Identifier: MIT
// What a study says: the cost of each scheme at a wanted accuracy, where one scheme overtakes
// another, and up to which R each is free of drift.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "polhode/run/study.hpp"

namespace polhode {

/// The least cost at which one scheme keeps its R at or below a wanted one.
struct CostAtRatio {
  double cost = 0;            ///< force evaluations per ps
  double error = 0;           ///< of the cost, from the errors of R at the points around
  double step = 0;            ///< [ps]
  double evaluations = 0;     ///< force evaluations per step
  double exponent = 0;        ///< local d log R / d log h
  bool extrapolated = false;  ///< below the smallest R measured, by the scheme's order
  bool longest = false;       ///< the longest step without drift, whose R is smaller than wanted
};

struct Guideline {
  double ratio = 0;                               ///< R
  std::vector<std::optional<CostAtRatio>> costs;  ///< per scheme; none: not reached without drift
  std::optional<std::size_t> best;                ///< the cheapest
};

/// The curve of one scheme: its points by growing step, the usable ones first.
struct Curve {
  std::string scheme;
  std::vector<EfficiencyPoint> points;
  std::size_t usable = 0;  ///< points before the first that drifts or blows up
};

/// The curves of a study, in the order in which its points name the schemes.
std::vector<Curve> curves(const std::vector<EfficiencyPoint>& points);

/// The curve up to where a run blew up, drift or not: for comparing costs alone.
Curve regardless_of_drift(Curve curve);

/// The cost at R, by interpolation of log h over log R between neighbouring usable points; where
/// even the longest usable step has a smaller R, the cost of that step.
std::optional<CostAtRatio> cost_at(const Curve& curve, double ratio);

std::vector<Guideline> guidelines(const std::vector<Curve>& curves,
                                  const std::vector<double>& ratios);

/// The R below which `finer` is cheaper than `coarser`, if the two curves cross where both are
/// measured, and its standard error.
std::optional<Estimate> crossover(const Curve& finer, const Curve& coarser);

}  // namespace polhode
