// SPDX-License-Identifier: MIT
// Optimal parameters of schemes for one system and step: η of the hoa2 family, and η and ξ of the
// gier4 family, from the covariances of the brackets in the O(h²) error (docs/theory.md, Eq. (35)).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "polhode/base/workers.hpp"
#include "polhode/measure/shadow.hpp"
#include "polhode/run/study/study.hpp"

namespace polhode {

/// B(η) A(1/2) B(1 − 2η, ξ) A(1/2) B(η) [vanzon2008, Eq. 1], which includes hoa2 and gier4.
Scheme family_scheme(double eta, double xi);

/// Covariances of the energy E of a run and its brackets: means of products of deviations of E,
/// a = h² V̈ and b = h² W [kJ²/mol²].
struct ErrorCovariance {
  double EE = 0, Ea = 0, Eb = 0, aa = 0, ab = 0, bb = 0;
  double VV = 0;  ///< of the potential energy, the denominator of R²

  ErrorCovariance& operator+=(const ErrorCovariance& other);
  /// The variance of the energy if the scheme's error terms change by that amount: that of E − Δα
  /// a − Δβ b, since H̃ of either scheme is constant.
  double variance(const ErrorTerms& change) const;
};
ErrorCovariance error_covariance(std::span<const BracketSample> samples, double h);

/// η and ξ of a member of the family.
struct FamilyMember {
  double eta = 0, xi = 0;
};

/// The η that minimises the variance without gradient kicks, from a run with `reference`.
FamilyMember best_plain(const ErrorCovariance& covariance, const Scheme& reference);
/// The η that minimises the fluctuation of α V̈ + β W: optimal in the limit of small steps.
FamilyMember best_plain_at_short_steps(const ErrorCovariance& covariance);
/// η and ξ that minimise the variance, from a run with `reference`: a linear least-squares problem
/// in α and β.
FamilyMember best_gradient(const ErrorCovariance& covariance, const Scheme& reference);

struct TuneSettings {
  double step = 0;         ///< [ps]; 0: that of the run file
  int runs = 4;            ///< for the measurement, and as many from other initial configurations
                           ///< for confirmation
  double length = 2;       ///< of each [ps]
  double decorrelate = 2;  ///< equilibration of each initial configuration [ps]
  double sample = 0.02;    ///< interval between brackets [ps]
};

/// Result for one family, compared with its member in the table of schemes.
struct Tuned {
  Scheme reference, scheme;
  FamilyMember member;
  FamilyMember error;               ///< standard errors by the jackknife over runs
  double predicted_gain = 1;        ///< R of the reference divided by R, from the covariances
  Estimate reference_ratio, ratio;  ///< R of both in the confirming runs
  Estimate gain;                    ///< R of the reference divided by R, in runs from the same
                                    ///< initial configurations
};

struct TuneResult {
  TuneSettings settings;
  std::size_t molecules = 0;
  ErrorCovariance covariance;  ///< from runs of hoa2, summed
  double short_steps = 0;      ///< η of best_plain_at_short_steps
  Tuned plain, gradient;
  bool interrupted = false;  ///< the numbers are meaningless
};

/// Correlation coefficient of the two brackets.
double correlation(const ErrorCovariance& covariance);
/// rms of a bracket, from the sum of its mean squares over the runs [kJ/mol].
double rms_bracket(double squares, const TuneSettings& settings);

/// The step of the settings is that of the run file unless it is given.
/// @throws RunError  if a run blows up
/// @throws Error     if the forces have no directional derivative, the run file has multiple time
///                   steps, or the runs hold fewer than 20 brackets
TuneResult tune(const Config& config, const TuneSettings& settings, const Callbacks& callbacks,
                Workers& workers = Workers::serial());

/// Names with units, as "step_fs".
std::string tune_json(const TuneResult& result);

}  // namespace polhode
