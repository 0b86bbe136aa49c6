// SPDX-License-Identifier: MIT
// Optimal parameters of schemes for a given system and step (docs/theory.md, Eq. (43)). The
// parameters are η of the hoa2 family, η and ξ of the gier4 family, or the free parameters of any
// palindrome.
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
  /// Text of a scheme with free parameters. If the text is empty, the scheme of the run file is
  /// tuned, provided that this scheme has free parameters. If the scheme has no free parameters,
  /// the families of hoa2 and gier4 are tuned.
  std::string scheme{};
  double step = 0;         ///< time step [ps]; 0: the step of the run file
  int runs = 4;            ///< number of runs for the measurement, and number of confirming runs
                           ///< from other initial configurations
  double length = 2;       ///< length of each run [ps]
  double decorrelate = 2;  ///< equilibration of each initial configuration [ps]
  double sample = 0.02;    ///< interval between samples of error brackets [ps]
};

struct TunedParameter {
  std::string name;
  double value = 0, error = 0;  ///< value of the parameter, and its jackknife standard error over
                                ///< runs
};

/// Result of tuning a family of schemes, compared with the reference scheme of the family.
struct Tuned {
  std::string reference;
  Scheme scheme;
  std::vector<TunedParameter> parameters;
  double predicted_gain = 1;  ///< R of the reference divided by R of the tuned scheme, predicted
                              ///< from the covariances
  Estimate reference_ratio{}, ratio{};  ///< R of the reference and of the tuned scheme in the
                                        ///< confirming runs
  Estimate gain{};  ///< R of the reference divided by R of the tuned scheme, in runs from the same
                    ///< initial configurations
};

struct TuneResult {
  TuneSettings settings;
  std::size_t molecules = 0;
  ErrorCovariance covariance;         ///< sum of the covariances of the runs with the reference of
                                      ///< the first family
  std::optional<double> short_steps;  ///< optimal η of the hoa2 family in the limit of short steps
  std::vector<Tuned> families;
  bool interrupted = false;  ///< whether tuning was interrupted; all results are then meaningless
};

/// Tunes the free parameters of schemes. The step is the step of the run file unless the settings
/// give a step.
/// @throws RunError  if a run blows up
/// @throws Error     if the forces have no directional derivative, the run file has multiple time
///   steps, or the runs hold fewer than 20 brackets; also under the conditions of SchemeFamily()
TuneResult tune(const Config& config, const TuneSettings& settings, const Callbacks& callbacks,
                Workers& workers = Workers::serial());

/// The results of the tuning as a list, from which text, JSON and the manual are made.
Quantities quantities(const TuneResult& result);

}  // namespace polhode
