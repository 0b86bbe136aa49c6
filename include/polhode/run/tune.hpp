// SPDX-License-Identifier: MIT
// Parameters of schemes for one system and step: the η of hoa2's family, and η and ξ of gier4's,
// from how the brackets of the O(h²) error fluctuate together (docs/theory.md, "Tuning").
#pragma once

#include <span>
#include <vector>

#include "polhode/base/workers.hpp"
#include "polhode/measure/shadow.hpp"
#include "polhode/run/study.hpp"

namespace polhode {

/// B(η) A(1/2) B(1 − 2η, ξ) A(1/2) B(η) (vanzon2008, Eq. 1); hoa2 and gier4 are two of these.
Scheme family_scheme(double eta, double xi);

/// How the energy E of a run and its brackets vary together: means of products of deviations, of
/// E, a = h² V̈ and b = h² W [kJ²/mol²].
struct ErrorCovariance {
  double EE = 0, Ea = 0, Eb = 0, aa = 0, ab = 0, bb = 0;
  double VV = 0;  ///< of the potential energy, the scale of R²

  ErrorCovariance& operator+=(const ErrorCovariance& other);
  /// The variance of the energy when a scheme's error terms change by so much: that of
  /// E − Δα a − Δβ b, as H̃ of either scheme is constant.
  double variance(const ErrorTerms& change) const;
};
ErrorCovariance error_covariance(std::span<const BracketSample> samples, double h);

/// η and ξ of a member of the family.
struct FamilyMember {
  double eta = 0, xi = 0;
};

/// The η of least variance without gradient, from a run with `reference`.
FamilyMember best_plain(const ErrorCovariance& covariance, const Scheme& reference);
/// The η of least fluctuation of α V̈ + β W: of short steps, where nothing else counts.
FamilyMember best_plain_at_short_steps(const ErrorCovariance& covariance);
/// η and ξ of least variance, from a run with `reference`: a linear least-squares problem in α and
/// β.
FamilyMember best_gradient(const ErrorCovariance& covariance, const Scheme& reference);

struct TuneSettings {
  double step = 0;         ///< [ps]
  int runs = 4;            ///< that measure, and as many from other starts that confirm
  double length = 2;       ///< of each [ps]
  double decorrelate = 2;  ///< preparation of each start [ps]
  double sample = 0.02;    ///< between brackets [ps]
};

/// What tuning brings to one family, beside the member of it that the table has.
struct Tuned {
  Scheme reference, scheme;
  FamilyMember member;
  FamilyMember error;               ///< standard errors by the jackknife over runs
  double predicted_gain = 1;        ///< R of the reference over R, from the covariances
  Estimate reference_ratio, ratio;  ///< R of both by runs that confirm
  Estimate gain;                    ///< R of the reference over R in runs from the same starts
};

struct TuneResult {
  ErrorCovariance covariance;  ///< along runs of hoa2, summed
  double short_steps = 0;      ///< η of best_plain_at_short_steps
  Tuned plain, gradient;
};

/// @throws RunError  if a run blows up
/// @throws Error     if the forces have no directional derivative
TuneResult tune(const Config& config, const TuneSettings& settings, const StudyProgress& progress,
                Workers& workers = Workers::serial());

}  // namespace polhode
