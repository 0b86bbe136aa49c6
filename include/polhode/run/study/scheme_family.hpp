// SPDX-License-Identifier: MIT
// Schemes with free parameters. The covariances of the brackets in the O(h²) error determine the
// parameters with the smallest energy fluctuation (docs/theory.md, "Tuning").
#pragma once

#include <span>
#include <string>
#include <vector>

#include "polhode/integrate/error_terms.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/io/settings/nested_scheme_text.hpp"
#include "polhode/measure/shadow.hpp"

namespace polhode {

/// A family of schemes with one or two free parameters, such as "free x = 0.2; B(x) A(1/2) B(1 -
/// 2*x) A(1/2) B(x)". The O(h²) error of a scheme has only two terms, with the prefactors α and β.
/// Two terms cannot determine a third parameter.
class SchemeFamily {
 public:
  /// @throws Error  unless the text is a palindrome with one or two free parameters that determine
  ///                α and β. The drifts and the kicks must sum to 1 for any parameter values
  /// @param label  label of the reference; if empty, it is the name of the scheme, or its stages
  explicit SchemeFamily(const NamedScheme& scheme, const std::string& label = {});

  const std::vector<FreeParameter>& parameters() const { return parameters_; }
  /// The reference: the scheme with the parameter values in the text.
  const Scheme& reference() const { return reference_; }
  /// The scheme with other parameter values, in the order of parameters().
  Scheme at(std::span<const double> values) const;
  /// The label of the reference in tables.
  const std::string& label() const { return label_; }

 private:
  std::string text_, label_;
  std::vector<FreeParameter> parameters_;
  Scheme reference_;
};

/// The family B(η) A(1/2) B(1 − 2η) A(1/2) B(η) with the reference hoa2. gier4_family() adds a
/// gradient kick in the middle, with the reference gier4 [vanzon2008, Eq. 1].
SchemeFamily hoa2_family();
SchemeFamily gier4_family();

/// Covariances of three quantities in a run: the energy E and the error brackets a = h² V̈ and b =
/// h² W [kJ²/mol²].
struct ErrorCovariance {
  double EE = 0, Ea = 0, Eb = 0, aa = 0, ab = 0, bb = 0;
  double VV = 0;  ///< variance of the potential energy, the denominator of R²

  ErrorCovariance& operator+=(const ErrorCovariance& other);
  /// The variance of the energy if the error terms of the scheme changed by `change`. The result is
  /// the variance of E − Δα a − Δβ b, because H̃ of both schemes is constant.
  double variance(const ErrorTerms& change) const;
};
ErrorCovariance error_covariance(std::span<const BracketSample> samples, double h);

ErrorTerms operator-(const ErrorTerms& a, const ErrorTerms& b);

/// The parameters that minimize the variance of the energy, computed from a run with the reference.
std::vector<double> best_parameters(const ErrorCovariance& covariance, const SchemeFamily& family);
/// The parameters that minimize the fluctuation of α V̈ + β W. These parameters are optimal for
/// short steps.
std::vector<double> best_at_short_steps(const ErrorCovariance& covariance,
                                        const SchemeFamily& family);

}  // namespace polhode
