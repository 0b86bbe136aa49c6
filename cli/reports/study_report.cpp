// SPDX-License-Identifier: MIT
#include "study_report.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <cmath>
#include <optional>
#include <string>

#include "io/files/with_error.hpp"
#include "io/settings/output_units.hpp"
#include "temperature_tables.hpp"

namespace polhode::cli {
namespace {

/// A mean over runs, with its error if there are enough of them.
std::string mean_text(const Estimate& e, int digits, int runs) {
  if (!std::isfinite(e.value)) return "-";
  return runs > 1 ? with_error(e.value, e.error) : fmt::format("{:.{}g}", e.value, digits);
}

/// What a user needs to know about a point, and why it is not part of the curve if it is not.
std::string note_on(const EfficiencyPoint& p, bool usable) {
  if (!p.stable) return "blew up";
  if (!usable)
    return p.drifts() ? "energy drifts: beyond the end of the curve"
                      : "beyond the end of the curve";
  if (p.drifts()) return "energy drifts, but not at longer steps";
  if (p.drift.significant()) return "significant energy drift, but small";
  if (p.relative_drift() >= drift_bound && std::abs(p.drift.rate.value) > 2 * p.drift.rate.error)
    return "large energy drift, but not significant: more runs needed";
  if (p.at_rounding()) return fmt::format("rounding alone gives {:.2g} %", 100 * p.rounding);
  return "";
}

void print_points(const StudyReport& report) {
  fmt::print("{:<18} {:>8} {:>10} {:>5} {:>18} {:>24}  {}\n", "scheme", "step fs", "cost 1/ps",
             "runs", "R %", "energy drift kJ/mol/ps", "");
  for (const Curve& curve : report.curves)
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      const EfficiencyPoint& p = curve.points[i];
      const std::string note = note_on(p, i < curve.usable);
      fmt::print("{:<18} {:>8.3g} {:>10.0f} {:>5} {:>18} {:>24}  {}\n", p.scheme,
                 p.step * units::fs_per_ps, p.cost, p.runs,
                 mean_text({100 * p.ratio.value, 100 * p.ratio.error}, 4, p.runs),
                 mean_text(p.drift.rate, 3, p.runs), note);
    }
}

/// The cost of scheme c, and its ratio to that of velocity Verlet where both are known.
std::string cost_text(const Guideline& line, std::size_t c, std::size_t verlet) {
  const std::optional<CostAtRatio>& cost = line.costs[c];
  if (!cost) return "-";
  std::string text = cost->at_max_step ? fmt::format("{:.0f}+", cost->cost)
                                       : fmt::format("{:.0f} ± {:.0f}{}", cost->cost, cost->error,
                                                     cost->extrapolated ? "*" : "");
  if (verlet < line.costs.size() && line.costs[verlet])
    text += fmt::format(" ({:.2f})", line.costs[verlet]->cost / cost->cost);
  return text;
}

void print_costs(const StudyReport& report) {
  std::size_t verlet = report.curves.size();
  for (std::size_t c = 0; c < report.curves.size(); ++c)
    if (report.curves[c].scheme == "velocity-verlet") verlet = c;
  fmt::print(
      "\nminimum cost for R at or below the given value, in force evaluations per ps{};\n"
      "* extrapolated by the scheme's order, + the longest step of the curve\n{:>8}",
      verlet < report.curves.size() ? " (ratio to velocity Verlet)" : "", "R %");
  for (const Curve& curve : report.curves) fmt::print(" {:>22}", curve.scheme);
  fmt::print("  best\n");
  for (const Guideline& line : report.guidelines) {
    fmt::print("{:>8g}", 100 * line.ratio);
    for (std::size_t c = 0; c < line.costs.size(); ++c)
      fmt::print(" {:>22}", cost_text(line, c, verlet));
    fmt::print("  {}\n", line.best ? report.curves[*line.best].scheme : "none");
  }
}

void print_claims(const StudyReport& report) {
  const auto& molecules = report.config.system.molecules;
  const bool of_the_paper =
      molecules.size() == 1 && molecules[0].model == "tip4p" && molecules[0].count == 512;
  if (!report.claims.empty())
    fmt::print("\nthe paper's claims [vanzon2008]{}\n",
               of_the_paper ? "" : "; they refer to 512 TIP4P waters, not to this system");
  for (const Claim& claim : report.claims)
    fmt::print("  {}{}: {}\n", claim.text,
               claim.value ? ": " + with_error(claim.value->value, claim.value->error) : "",
               in_words(claim.verdict));
}

}  // namespace

void print_study(const StudyReport& report) {
  fmt::print("{}\n\n", conditions(report.config));
  print_points(report);
  print_costs(report);
  print_temperatures(report.curves, report.equipartition);
  print_claims(report);
  fmt::print("\n{}\nfiles {}\n", advice(report, 0.005), fmt::join(report.files, " "));
}

}  // namespace polhode::cli
