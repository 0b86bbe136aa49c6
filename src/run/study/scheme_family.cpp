// SPDX-License-Identifier: MIT
#include "polhode/run/study/scheme_family.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>

#include "io/settings/scheme_labels.hpp"
#include "polhode/base/error.hpp"
#include "polhode/integrate/schemes.hpp"
#include "polhode/io/settings/nested_scheme_text.hpp"

namespace polhode {
namespace {

using Values = std::vector<double>;

constexpr double displacement = 1e-6;  // displacement of a parameter, for numerical derivatives
constexpr const char* example_family = "free x = 0.2; B(x) A(1/2) B(1 - 2*x) A(1/2) B(x)";

Values values_of(const std::vector<FreeParameter>& parameters) {
  Values values;
  for (const FreeParameter& p : parameters) values.push_back(p.value);
  return values;
}

/// The derivatives ∂(α, β)/∂p for each parameter p, by central differences. The central differences
/// are exact to 1e-9, because α and β are polynomials of the coefficients.
std::vector<ErrorTerms> slopes(const SchemeFamily& family, const Values& at) {
  std::vector<ErrorTerms> all;
  for (std::size_t k = 0; k < at.size(); ++k) {
    Values up = at, down = at;
    up[k] += displacement, down[k] -= displacement;
    const ErrorTerms d = error_terms(family.at(up)) - error_terms(family.at(down));
    all.push_back({d.alpha / (2 * displacement), d.beta / (2 * displacement)});
  }
  return all;
}

/// Whether the derivatives of α and β with respect to the parameters are linearly independent.
bool independent(const std::vector<ErrorTerms>& s) {
  constexpr double min_slope = 1e-7;  // smallest slope for coefficients of the order of 1
  if (s.size() == 1) return std::hypot(s[0].alpha, s[0].beta) > min_slope;
  return std::abs(s[0].alpha * s[1].beta - s[0].beta * s[1].alpha) > min_slope * min_slope;
}

void check_count(const std::vector<FreeParameter>& parameters) {
  if (parameters.size() == 1 || parameters.size() == 2) return;
  throw Error(
      fmt::format("the scheme has {} free parameters; it must have one or two, since its error of "
                  "order h² has two terms: write for example \"{}\"",
                  parameters.size(), example_family));
}

/// The symmetric 2 × 2 covariance matrix of the two error brackets (the commutators with the
/// factors α and β). If the two error brackets are perfectly correlated, one combination of the
/// parameters is undetermined. A small additional term in the variance prevents changes of the
/// undetermined combination.
struct Metric {
  double aa, ab, bb;
  explicit Metric(const ErrorCovariance& c)
      : aa(c.aa * (1 + min_part)), ab(c.ab), bb(c.bb * (1 + min_part)) {}
  double operator()(const ErrorTerms& x, const ErrorTerms& y) const {
    return aa * x.alpha * y.alpha + ab * (x.alpha * y.beta + x.beta * y.alpha) +
           bb * x.beta * y.beta;
  }
  static constexpr double min_part = 1e-9;
};

/// The step δ of a damped Gauss-Newton iteration for one or two parameters solves (S + μ diag S) δ
/// = −gradient. S and the gradient are half of the derivatives of the variance.
Values newton_step(const std::vector<ErrorTerms>& s, const Metric& metric, const Values& gradient,
                   double damping) {
  const double xx = metric(s[0], s[0]) * (1 + damping);
  if (s.size() == 1) return {-gradient[0] / xx};
  const double yy = metric(s[1], s[1]) * (1 + damping), xy = metric(s[0], s[1]);
  const double determinant = xx * yy - xy * xy;
  return {(-gradient[0] * yy + gradient[1] * xy) / determinant,
          (-gradient[1] * xx + gradient[0] * xy) / determinant};
}

/// Minimizes the variance for error terms relative to `from` (Levenberg-Marquardt).
Values minimum(const ErrorCovariance& c, const SchemeFamily& family, const ErrorTerms& from) {
  const Metric metric(c);
  const auto change = [&](const Values& at) { return error_terms(family.at(at)) - from; };
  // The variance is infinite if the text of the scheme cannot be evaluated, as for the root of a
  // negative number.
  const auto cost = [&](const Values& at) {
    try {
      const ErrorTerms d = change(at);
      return metric(d, d) - 2 * (d.alpha * c.Ea + d.beta * c.Eb);
    } catch (const Error&) {
      return std::numeric_limits<double>::infinity();
    }
  };
  Values at = values_of(family.parameters());
  double damping = 1e-3;
  constexpr int max_iterations = 200;  // about ten are needed
  for (int i = 0; i < max_iterations && damping < 1e12; ++i) {
    const std::vector<ErrorTerms> s = slopes(family, at);
    const ErrorTerms d = change(at);
    Values gradient;
    for (const ErrorTerms& slope : s)
      gradient.push_back(metric(slope, d) - slope.alpha * c.Ea - slope.beta * c.Eb);
    Values next = newton_step(s, metric, gradient, damping);
    for (std::size_t k = 0; k < at.size(); ++k) next[k] += at[k];
    const bool better = cost(next) < cost(at);
    if (better) at = next;
    damping *= better ? 0.1 : 10;
  }
  return at;
}

}  // namespace

SchemeFamily::SchemeFamily(const NamedScheme& scheme, const std::string& label)
    : text_(scheme.text),
      label_(label.empty() ? label_of(scheme) : label),
      parameters_(free_parameters(text_)),
      reference_(single_scheme_of(scheme)) {
  check_count(parameters_);
  if (!reference_.palindromic())
    throw Error(
        fmt::format("{} is not a palindrome, so it has an error of order h with unknown terms; "
                    "write stages that read the same from both ends, for example \"{}\"",
                    label_, example_family));
  bool distinct = false;
  try {
    distinct = independent(slopes(*this, values_of(parameters_)));
  } catch (const Error& e) {
    throw Error(
        fmt::format("the stages of {} do not form a scheme when a free parameter changes by {:g}: "
                    "{}; express the other coefficients by the parameter, as in \"{}\"",
                    label_, displacement, e.what(), example_family));
  }
  if (!distinct)
    throw Error(fmt::format(
        "the error of order h² of {} does not depend on {}, so this parameter cannot be tuned; "
        "give it a fixed value, or use a parameter that changes the stages",
        label_,
        parameters_.size() == 1 ? parameters_[0].name : "its two parameters independently"));
}

Scheme SchemeFamily::at(std::span<const double> values) const {
  std::vector<FreeParameter> parameters = parameters_;
  for (std::size_t k = 0; k < parameters.size(); ++k) parameters[k].value = values[k];
  return scheme_of(text_, parameters);
}

SchemeFamily hoa2_family() {
  return SchemeFamily(fmt::format("free eta = {}; B(eta) A(1/2) B(1 - 2*eta) A(1/2) B(eta)", eta),
                      "hoa2");
}

SchemeFamily gier4_family() {
  return SchemeFamily(
      "free eta = 1/6; free xi = 1/48; B(eta) A(1/2) B(1 - 2*eta, xi) A(1/2) B(eta)", "gier4");
}

ErrorTerms operator-(const ErrorTerms& a, const ErrorTerms& b) {
  return {a.alpha - b.alpha, a.beta - b.beta};
}

ErrorCovariance& ErrorCovariance::operator+=(const ErrorCovariance& other) {
  EE += other.EE, Ea += other.Ea, Eb += other.Eb;
  aa += other.aa, ab += other.ab, bb += other.bb;
  VV += other.VV;
  return *this;
}

double ErrorCovariance::variance(const ErrorTerms& change) const {
  const auto [x, y] = change;
  return EE - 2 * (x * Ea + y * Eb) + x * x * aa + 2 * x * y * ab + y * y * bb;
}

ErrorCovariance error_covariance(std::span<const BracketSample> samples, double h) {
  struct Row {
    double E, a, b, V;
  };
  std::vector<Row> rows;
  Row mean{};
  const auto n = static_cast<double>(samples.size());
  for (const BracketSample& s : samples) {
    rows.push_back({s.energies.total(), h * h * s.brackets.second_derivative, h * h * s.brackets.W,
                    s.energies.potential()});
    const Row& r = rows.back();
    mean.E += r.E / n, mean.a += r.a / n, mean.b += r.b / n, mean.V += r.V / n;
  }
  ErrorCovariance c;
  for (const Row& r : rows) {
    const double E = r.E - mean.E, a = r.a - mean.a, b = r.b - mean.b, V = r.V - mean.V;
    c += {E * E / n, E * a / n, E * b / n, a * a / n, a * b / n, b * b / n, V * V / n};
  }
  return c;
}

Values best_parameters(const ErrorCovariance& covariance, const SchemeFamily& family) {
  return minimum(covariance, family, error_terms(family.reference()));
}

Values best_at_short_steps(const ErrorCovariance& covariance, const SchemeFamily& family) {
  ErrorCovariance brackets = covariance;
  brackets.EE = brackets.Ea = brackets.Eb = 0;
  return minimum(brackets, family, {});
}

}  // namespace polhode
