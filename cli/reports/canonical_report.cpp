// SPDX-License-Identifier: MIT
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <cmath>
#include <optional>

#include "io/files/with_error.hpp"
#include "io/settings/output_units.hpp"
#include "study_report.hpp"

namespace polhode::cli {
namespace {

std::string estimate_text(const std::optional<Estimate>& e) {
  if (!e || !std::isfinite(e->value)) return "-";
  return with_error(e->value, e->error);
}

/// A bias, marked if it is known to be above its bounds.
std::string bias_text(const CanonicalPoint& point, std::size_t quantity) {
  const auto above = [&](BiasCriterion criterion) {
    return point.accuracy(quantity, criterion) == Accuracy::above;
  };
  const char* mark = above(BiasCriterion::loose)    ? "**"
                     : above(BiasCriterion::strict) ? "* "
                                                    : "  ";
  return estimate_text(point.bias[quantity]) + mark;
}

std::string note_on(const CanonicalPoint& p) {
  if (!p.stable) return "blew up";
  std::string text = fmt::format("{}, loosely {}", in_words(p.accuracy(BiasCriterion::strict)),
                                 in_words(p.accuracy(BiasCriterion::loose)));
  if (p.method.hybrid)
    text += fmt::format(", acceptance {:.0f} %, <exp(-dH/kT)> {}", 100 * p.acceptance.value,
                        with_error(p.weight.value, p.weight.error));
  return text;
}

void print_points(const CanonicalReport& report) {
  fmt::print(
      "bias of: U per molecule [kJ/mol], configurational temperatures of translation and "
      "rotation [K], kinetic\ntemperatures of both [K], first peak of g(r); * above the "
      "strict bound, ** above the loose one\n\n");
  fmt::print("{:<16} {:>7} {:>8} {:>4} {:>16} {:>13} {:>13} {:>13} {:>13} {:>16} {:>15}  {}\n",
             "scheme", "step fs", "cost/ps", "runs", "U", "T_conf trans", "T_conf rot",
             "T_kin trans", "T_kin rot", "g peak", "cost/sample", "biases");
  for (const CanonicalPoint& p : report.points)
    fmt::print(
        "{:<16} {:>7.3g} {:>8.0f} {:>4} {:>16} {:>13} {:>13} {:>13} {:>13} {:>16} {:>15}  {}\n",
        p.method.name, p.method.step * units::fs_per_ps, p.method.cost(), p.runs, bias_text(p, 0),
        bias_text(p, 1), bias_text(p, 2), bias_text(p, 3), bias_text(p, 4), bias_text(p, 5),
        estimate_text(p.evaluations_per_sample()), note_on(p));
}

void print_findings(const CanonicalFindings& findings, const std::vector<CanonicalPoint>& points) {
  fmt::print("\n{} bounds:", in_words(findings.criterion));
  for (const CanonicalQuantity& q : canonical_quantities)
    fmt::print("{} {} {:g}{}{}", &q == canonical_quantities.data() ? "" : ",", q.label,
               q.bound(findings.criterion), std::string_view(q.unit) == "1" ? "" : " ",
               std::string_view(q.unit) == "1" ? "" : q.unit);
  fmt::print("; with 95 % confidence\n");
  for (const std::string& sentence : canonical_sentences(findings, points))
    fmt::print("  {}\n", sentence);
}

}  // namespace

void print_study(const CanonicalReport& report) {
  fmt::print("{}\n", canonical_conditions(report.config));
  print_points(report);
  for (const CanonicalFindings& findings : report.findings) print_findings(findings, report.points);
  fmt::print("\nfiles {}\n", fmt::join(report.files, " "));
}

}  // namespace polhode::cli
