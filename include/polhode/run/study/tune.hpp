// SPDX-License-Identifier: MIT
// Optimal parameters of schemes for one system and step: η of the hoa2 family and η and ξ of the
// gier4 family, or the free parameters of any palindrome (docs/theory.md, Eq. (43)).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "polhode/base/workers.hpp"
#include "polhode/run/quantities.hpp"
#include "polhode/run/study/scheme_family.hpp"
#include "polhode/run/study/study.hpp"

namespace polhode {

struct TuneSettings {
  /// Text with free parameters; empty: the scheme of the run file if it has any, otherwise the
  /// families of hoa2 and gier4.
  std::string scheme{};
  double step = 0;         ///< [ps]; 0: step of the run file
  int runs = 4;            ///< runs to measure, and as many from other initial configurations
                           ///< for confirmation
  double length = 2;       ///< length of each run [ps]
  double decorrelate = 2;  ///< equilibration of each initial configuration [ps]
  double sample = 0.02;    ///< interval between brackets [ps]
};

struct TunedParameter {
  std::string name;
  double value = 0, error = 0;  ///< value, and its standard error by the jackknife over runs
};

/// Result for one family, compared with its reference.
struct Tuned {
  std::string reference;
  Scheme scheme;
  std::vector<TunedParameter> parameters;
  double predicted_gain = 1;            ///< R of the reference divided by R, from the covariances
  Estimate reference_ratio{}, ratio{};  ///< R of both in the confirming runs
  Estimate gain{};  ///< R of the reference divided by R, in runs from the same initial
                    ///< configurations
};

struct TuneResult {
  TuneSettings settings;
  std::size_t molecules = 0;
  ErrorCovariance covariance;         ///< covariance from runs of the first reference, summed
  std::optional<double> short_steps;  ///< η of the hoa2 family in the limit of short steps
  std::vector<Tuned> families;
  bool interrupted = false;  ///< the numbers are meaningless
};

/// Correlation coefficient of the two brackets.
double correlation(const ErrorCovariance& covariance);
/// rms of a bracket, from the sum of its mean squares over the runs [kJ/mol].
double rms_bracket(double squares, const TuneSettings& settings);

/// Uses the step of the run file unless the settings give one.
/// @throws RunError  if a run blows up
/// @throws Error     if the forces have no directional derivative, the run file has multiple time
///                   steps, the runs hold fewer than 20 brackets, or as SchemeFamily()
TuneResult tune(const Config& config, const TuneSettings& settings, const Callbacks& callbacks,
                Workers& workers = Workers::serial());

/// The results as a list, from which text, JSON and the manual follow.
Quantities quantities(const TuneResult& result);

}  // namespace polhode
