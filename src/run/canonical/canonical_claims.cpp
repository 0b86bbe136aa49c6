// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "io/files/with_error.hpp"
#include "io/settings/output_units.hpp"
#include "math/prediction.hpp"
#include "run/canonical/canonical_report.hpp"

namespace polhode {
namespace {

/// Whether the costs of two points differ: the 95 % confidence interval of their difference
/// excludes 0.
bool distinguishable(const CanonicalPoint& one, const CanonicalPoint& other) {
  const Estimate a = one.evaluations_per_sample(), b = other.evaluations_per_sample();
  const ErrorPart doubt = summed({{a.error, one.runs - 1.0}, {b.error, other.runs - 1.0}});
  return std::abs(a.value - b.value) > confidence_half_width(doubt);
}

/// The result for a scheme from its points, in the order of the steps.
CanonicalClaim claim_of(const std::string& scheme, BiasCriterion criterion,
                        const std::vector<CanonicalPoint>& points) {
  std::vector<std::size_t> own;
  for (std::size_t k = 0; k < points.size(); ++k)
    if (points[k].method.name == scheme) own.push_back(k);
  std::sort(own.begin(), own.end(),
            [&](auto a, auto b) { return points[a].method.step < points[b].method.step; });
  CanonicalClaim claim{.scheme = scheme, .accurate = {}, .beyond = {}};
  bool accurate = true;
  for (const std::size_t k : own) {
    const Accuracy accuracy = points[k].accuracy(criterion);
    accurate = accurate && accuracy == Accuracy::below;
    if (accurate) claim.accurate = k;
    if (accuracy == Accuracy::above && !claim.beyond) claim.beyond = k;
  }
  return claim;
}

std::string step_text(const CanonicalPoint& point) {
  return fmt::format("{:g} fs", point.method.step * units::fs_per_ps);
}

std::string sentence(const CanonicalClaim& claim, BiasCriterion criterion,
                     const std::vector<CanonicalPoint>& points) {
  std::string text = claim.scheme;
  if (claim.accurate)
    text += fmt::format(
        ": all biases are below their bounds for steps up to {}, at {:.0f} force evaluations per "
        "ps",
        step_text(points[*claim.accurate]), points[*claim.accurate].method.cost());
  else
    text += ": no time step is shown to have all biases below their bounds";
  if (claim.beyond) {
    const CanonicalPoint& point = points[*claim.beyond];
    text += fmt::format("; at {} ", step_text(point));
    if (!point.stable) return text + "a run blew up";
    std::string which;
    for (std::size_t k = 0; k < canonical_quantities.size(); ++k)
      if (point.accuracy(k, criterion) == Accuracy::above)
        which += fmt::format(
            "{}{} ({} {})", which.empty() ? "" : ", ", canonical_quantities[k].label,
            with_error(point.bias[k]->value, point.bias[k]->error), canonical_quantities[k].unit);
    text += "above: " + which;
  }
  return text;
}

/// The names of methods as text, such as "baoab at 4 fs, hoa2-ends at 8 fs".
std::string names_of(const std::vector<std::size_t>& which,
                     const std::vector<CanonicalPoint>& points) {
  std::string names;
  for (const std::size_t k : which)
    names += fmt::format("{}{} at {}", names.empty() ? "" : ", ", points[k].method.name,
                         step_text(points[k]));
  return names;
}

}  // namespace

CanonicalFindings::CanonicalFindings(BiasCriterion chosen,
                                     const std::vector<CanonicalPoint>& points)
    : criterion(chosen) {
  for (const CanonicalPoint& point : points)
    if (claims.empty() || claims.back().scheme != point.method.name)
      claims.push_back(claim_of(point.method.name, criterion, points));
  std::vector<std::size_t> known;  // points with a known cost
  for (std::size_t k = 0; k < points.size(); ++k)
    if (std::isfinite(points[k].evaluations_per_sample().value)) known.push_back(k);
  const auto sample = [&](std::size_t k) { return points[k].evaluations_per_sample(); };
  for (const std::size_t k : known)
    if (points[k].accuracy(criterion) == Accuracy::below &&
        (!cheapest || sample(k).value < sample(*cheapest).value))
      cheapest = k;
  if (!cheapest) return;
  for (const std::size_t k : known) {
    const bool distinct = distinguishable(points[k], points[*cheapest]);
    const Accuracy accuracy = points[k].accuracy(criterion);
    if (k != *cheapest && accuracy == Accuracy::below && !distinct) as_cheap.push_back(k);
    if (accuracy == Accuracy::undecided && (!distinct || sample(k).value < sample(*cheapest).value))
      undecided.push_back(k);
  }
}

CanonicalReport::CanonicalReport(const Config& config_used,
                                 const std::vector<CanonicalPoint>& points_found)
    : config(config_used),
      points(points_found),
      findings{CanonicalFindings(BiasCriterion::strict, points),
               CanonicalFindings(BiasCriterion::loose, points)} {}

std::vector<std::string> canonical_sentences(const CanonicalFindings& findings,
                                             const std::vector<CanonicalPoint>& points) {
  std::vector<std::string> sentences;
  for (const CanonicalClaim& claim : findings.claims)
    sentences.push_back(sentence(claim, findings.criterion, points));
  if (!findings.cheapest) {
    sentences.emplace_back(
        "the cheapest unbiased sample is not known: no point has both a known correlation time and "
        "all biases below their bounds");
    return sentences;
  }
  const Estimate cost = points[*findings.cheapest].evaluations_per_sample();
  std::string text = fmt::format(
      "the cheapest independent sample with all biases below their bounds: {}, {} force "
      "evaluations",
      names_of({*findings.cheapest}, points), with_error(cost.value, cost.error));
  if (!findings.as_cheap.empty())
    text += "; not distinguishable in cost: " + names_of(findings.as_cheap, points);
  if (!findings.undecided.empty())
    text += "; equally cheap or cheaper, but with biases not known to be below their bounds: " +
            names_of(findings.undecided, points);
  sentences.push_back(text);
  return sentences;
}

}  // namespace polhode
