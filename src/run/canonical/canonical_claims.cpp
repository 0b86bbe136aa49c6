// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "polhode/io/output_units.hpp"
#include "polhode/io/with_error.hpp"
#include "polhode/run/canonical/canonical_report.hpp"

namespace polhode {
namespace {

/// Two estimates whose 95 % intervals of the difference include 0.
bool distinguishable(const Estimate& a, const Estimate& b) {
  return std::abs(a.value - b.value) > 1.96 * std::hypot(a.error, b.error);
}

/// The points of a scheme, in the order of their steps.
CanonicalClaim claim_of(const std::string& scheme, const std::vector<CanonicalPoint>& points) {
  std::vector<std::size_t> own;
  for (std::size_t k = 0; k < points.size(); ++k)
    if (points[k].method.name == scheme) own.push_back(k);
  std::sort(own.begin(), own.end(),
            [&](auto a, auto b) { return points[a].method.step < points[b].method.step; });
  CanonicalClaim claim{.scheme = scheme, .accurate = {}, .beyond = {}};
  bool accurate = true;
  for (const std::size_t k : own) {
    const Accuracy accuracy = points[k].accuracy();
    accurate = accurate && accuracy == Accuracy::below;
    if (accurate) claim.accurate = k;
    if (accuracy == Accuracy::above && !claim.beyond) claim.beyond = k;
  }
  return claim;
}

std::string step_text(const CanonicalPoint& point) {
  return fmt::format("{:g} fs", point.method.step * units::fs_per_ps);
}

std::string sentence(const CanonicalClaim& claim, const std::vector<CanonicalPoint>& points) {
  std::string text = claim.scheme;
  if (claim.accurate)
    text += fmt::format(
        ": all biases are below their bounds up to {}, at {:.0f} force evaluations "
        "per ps",
        step_text(points[*claim.accurate]), points[*claim.accurate].method.cost());
  else
    text += ": no step is shown to have all biases below their bounds";
  if (claim.beyond) {
    const CanonicalPoint& point = points[*claim.beyond];
    text += fmt::format("; at {} ", step_text(point));
    if (!point.stable) return text + "a run blew up";
    std::string which;
    for (std::size_t k = 0; k < canonical_quantities.size(); ++k)
      if (point.accuracy(k) == Accuracy::above)
        which += fmt::format(
            "{}{} ({} {})", which.empty() ? "" : ", ", canonical_quantities[k].label,
            with_error(point.bias[k]->value, point.bias[k]->error), canonical_quantities[k].unit);
    text += "above: " + which;
  }
  return text;
}

}  // namespace

CanonicalReport::CanonicalReport(const Config& config_used,
                                 const std::vector<CanonicalPoint>& points_found)
    : config(config_used), points(points_found) {
  for (const CanonicalPoint& point : points)
    if (claims.empty() || claims.back().scheme != point.method.name)
      claims.push_back(claim_of(point.method.name, points));
  const auto sample = [&](std::size_t k) { return points[k].evaluations_per_sample(); };
  for (std::size_t k = 0; k < points.size(); ++k)
    if (points[k].accuracy() == Accuracy::below && std::isfinite(sample(k).value) &&
        (!cheapest || sample(k).value < sample(*cheapest).value))
      cheapest = k;
  for (std::size_t k = 0; cheapest && k < points.size(); ++k)
    if (k != *cheapest && points[k].accuracy() == Accuracy::below &&
        std::isfinite(sample(k).value) && !distinguishable(sample(k), sample(*cheapest)))
      as_cheap.push_back(k);
}

std::vector<std::string> canonical_sentences(const CanonicalReport& report) {
  std::vector<std::string> sentences;
  for (const CanonicalClaim& claim : report.claims)
    sentences.push_back(sentence(claim, report.points));
  if (!report.cheapest) {
    sentences.push_back(
        "the cheapest unbiased sample is not known: no point has all biases below "
        "their bounds and a correlation time");
    return sentences;
  }
  const CanonicalPoint& best = report.points[*report.cheapest];
  const Estimate cost = best.evaluations_per_sample();
  std::string text = fmt::format(
      "the cheapest independent sample with all biases below their bounds: {} at {}, {} force "
      "evaluations",
      best.method.name, step_text(best), with_error(cost.value, cost.error));
  std::string others;
  for (const std::size_t k : report.as_cheap)
    others += fmt::format("{}{} at {}", others.empty() ? "" : ", ", report.points[k].method.name,
                          step_text(report.points[k]));
  if (!others.empty()) text += "; not distinguishable from it: " + others;
  sentences.push_back(text);
  return sentences;
}

}  // namespace polhode
