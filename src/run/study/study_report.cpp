// SPDX-License-Identifier: MIT
#include "run/study/study_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "io/figures/plot.hpp"
#include "io/files/with_error.hpp"
#include "io/settings/output_units.hpp"
#include "polhode/base/error.hpp"
#include "polhode/run/simulation/trajectory/trajectory_settings.hpp"
#include "run/quantity_lists.hpp"
#include "run/simulation/system/near_forces.hpp"
#include "study_job.hpp"

namespace polhode {
namespace {

// Values of R for which the guideline table lists costs, including the values of the paper.
const std::vector<double> table_ratios = {0.03, 0.015, 0.01, 0.007, 0.004, 0.002, 0.001, 0.0001};

/// A mean over runs; the error of the mean is not known if there is only one run.
Estimate over_runs(const EfficiencyPoint& p, Estimate mean) {
  if (p.runs < 2) mean.error = std::nan("");
  return mean;
}

/// A note for the user on a point, for example why the point is not part of the curve.
std::string note_on(const EfficiencyPoint& p, bool usable) {
  if (!p.stable) return "blew up";
  if (!usable)
    return p.drifts() ? "energy drifts: beyond the end of the curve"
                      : "beyond the end of the curve";
  if (p.drifts()) return "energy drifts, but not at longer steps";
  if (p.drift.significant()) return "significant energy drift, but small";
  if (p.relative_drift() >= drift_bound && std::abs(p.drift.rate.value) > 2 * p.drift.rate.error)
    return "large energy drift, but not significant: more runs needed";
  if (p.at_rounding()) return fmt::format("round-off limit of R: {:.2g} %", 100 * p.rounding);
  return "";
}

Quantities of_point(const EfficiencyPoint& p, bool usable) {
  Quantities list = {
      {"scheme", "", p.scheme, "name of the scheme, or its stages", "scheme"},
      {"step", "fs", p.step * units::fs_per_ps, "time step", "step"},
      {"force_evaluations", "1/ps", p.cost, "cost in force evaluations per ps", "cost", "", "cost"},
      {"runs", "", p.runs, "number of independent runs", "runs"},
      {"stable", "", p.stable, "whether no run blew up"},
      {"usable", "", usable,
       "whether the point belongs to the curve; beyond the end of a curve, the energy drifts at "
       "every step"},
      {"R", "%", over_runs(p, p.ratio),
       "rms fluctuation of the total energy, divided by the rms fluctuation of the potential "
       "energy; `R_error` is the standard error",
       "R"},
      {"drift", "kJ/mol/ps", over_runs(p, p.drift.rate),
       "energy drift; `drift_error` is the standard error", "energy drift"},
      {"drift_p_value", "", p.runs > 1 ? p.drift.p_value : std::nan(""),
       "probability that chance gives a drift of at least this size"},
      {"relative_drift", "", p.relative_drift(),
       "energy change due to the drift during a run, divided by the rms fluctuation of the energy"},
      {"temperature", "K", p.temperature, "mean kinetic temperature"},
      {"R_rounding", "", p.rounding, "estimated round-off limit of R; 0 in double precision"},
      {"rounded", "", p.at_rounding(), "whether R is less than twice `R_rounding`"},
      {"near_weight", "", p.near_weight,
       "time of a near-force evaluation, divided by the time of an evaluation of all forces"}};
  append(list, excesses(p));
  list.push_back(row("remark", note_on(p, usable)));
  return list;
}

std::vector<Quantities> point_records(const StudyReport& report) {
  std::vector<Quantities> records;
  for (const Curve& curve : report.curves)
    for (std::size_t i = 0; i < curve.points.size(); ++i)
      records.push_back(of_point(curve.points[i], i < curve.usable));
  return records;
}

/// The cost of scheme c, and its ratio to the cost of velocity Verlet if both are known.
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

Quantities of_guideline(const Guideline& line, const std::vector<Curve>& curves,
                        std::size_t verlet) {
  Quantities list = {{"R", "%", line.ratio, "value of R", "R"}}, costs;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    list.push_back(row(curves[c].scheme, cost_text(line, c, verlet)));
    if (const std::optional<CostAtRatio>& cost = line.costs[c])
      costs.push_back({curves[c].scheme, "",
                       Quantities{{"force_evaluations", "1/ps", cost->cost},
                                  {"error", "", cost->error},
                                  {"step", "fs", cost->step * units::fs_per_ps},
                                  {"extrapolated", "", cost->extrapolated},
                                  {"max_step_without_drift", "", cost->at_max_step}}});
  }
  list.push_back({"costs", "", costs,
                  "cost of each scheme that reaches this R: `force_evaluations_per_ps` and its "
                  "`error`, the time step `step_fs`, whether the cost is `extrapolated`, and "
                  "whether the step is the `max_step_without_drift`"});
  list.push_back({line.best ? "best" : "", "", line.best ? curves[*line.best].scheme : "none",
                  "scheme that reaches this R at the lowest cost", "best"});
  return list;
}

Quantity of_guidelines(const StudyReport& report) {
  const auto& curves = report.curves;
  const auto verlet = static_cast<std::size_t>(
      std::find_if(curves.begin(), curves.end(),
                   [](const Curve& curve) { return curve.scheme == "velocity-verlet"; }) -
      curves.begin());
  std::vector<Quantities> lines;
  for (const Guideline& line : report.guidelines)
    lines.push_back(of_guideline(line, curves, verlet));
  return detail(
      {"guidelines", "", lines, "lowest cost of each scheme at several values of R",
       fmt::format("minimum cost for R at or below the given value, in force evaluations per "
                   "ps{};\n* extrapolated by the scheme's order, + the longest step of the curve",
                   verlet < curves.size() ? " (ratio to velocity Verlet)" : "")});
}

/// The verdict on a claim of the paper, and the claim with the value found.
Quantity row_of(const Claim& claim) {
  const std::string value =
      claim.value ? fmt::format(": {}", with_error(claim.value->value, claim.value->error)) : "";
  return row(claim.verdict == Verdict::undecided ? "not decided" : in_words(claim.verdict),
             claim.text + value);
}

/// The claims of the paper in JSON, and as rows of the text.
Quantities of_claims(const StudyReport& report) {
  const auto& molecules = report.config.system.molecules;
  const bool of_the_paper =
      molecules.size() == 1 && molecules[0].model == "tip4p" && molecules[0].count == 512;
  std::vector<Quantities> list;
  Quantities rows;
  for (const Claim& claim : report.claims) {
    list.push_back({{"claim", "", claim.text, "claim of the paper"},
                    {"verdict", "", in_words(claim.verdict),
                     "verdict: `reproduced`, `not reproduced` or `not decided by these data`"}});
    if (claim.value)
      append(list.back(), {{"value", "", claim.value->value}, {"error", "", claim.value->error}});
    rows.push_back(row_of(claim));
  }
  if (list.empty()) return {};
  return {{"claims", "", list, "claims of the paper"},
          {"", "", rows, "",
           fmt::format("the paper's claims [vanzon2008]{}",
                       of_the_paper ? "" : ", which refer to 512 TIP4P waters")}};
}

/// The caption of the figure, with the conditions under which the curves are compared.
std::string caption(const Config& config) {
  std::string molecules;
  for (const auto& component : config.system.molecules)
    molecules +=
        fmt::format("{}{} {}", molecules.empty() ? "" : ", ", component.count, component.model);
  return fmt::format(
      "Points further left and lower are better; R = 0 is exact dynamics. {}; {} runs of {:g} ps "
      "per point{}.",
      molecules.empty() ? config.source : molecules, config.study.runs, config.study.length,
      config.output.processed ? ", read through postprocessors" : "");
}

EfficiencyFigure figure(const StudyReport& report, const std::string& csv) {
  EfficiencyFigure figure{csv, {}, caption(report.config)};
  std::size_t rows = 0;
  for (const Curve& curve : report.curves) {
    const std::size_t first = rows;
    rows += curve.points.size();
    if (curve.usable > 0) figure.schemes.push_back({curve.scheme, first, rows - 1});
  }
  return figure;
}

/// A study of energy conservation.
struct EnergyStudy {
  using Run = StudyRun;
  using Report = StudyReport;

  static constexpr const char* title = "study";
  static constexpr auto identity = study_identity;
  static constexpr auto perform = perform_study_runs;
  static constexpr auto records_of = point_records;
  static constexpr auto figure_of = figure;

  const Config& config;
  std::vector<StudyPoint> all = study_points(config.study);

  std::size_t points() const { return all.size(); }

  void check(const System& system) const {
    for (const StudyPoint& point : all) {
      if (config.study.length < 10 * point.step)
        throw Error(
            fmt::format(
                "the study's length of {:g} fs is less than ten steps of {:g} fs, too few for R; "
                "use longer runs, or leave out long steps",
                config.study.length * units::fs_per_ps, point.step * units::fs_per_ps),
            config.source);
      check_near(system.forces, point.scheme, config.source);
      at_place(config.source, [&] {
        TrajectorySettings{.scheme = point.scheme.outer,
                           .inner = point.scheme.inner,
                           .processed = config.output.processed}
            .check_processed();
      });
    }
  }

  void note(const Callbacks& callbacks) const {
    note_constant_energy(config, "the study", callbacks);
  }

  StudyReport report(const System& system, const std::vector<StudyRun>& runs) const {
    Config used = config;
    used.forces.mixing = system.forces.mixing;  // known only after the topology file is read
    return {used, efficiency_points(all, runs, config.study.length)};
  }
};

/// A sentence on the cutoff, initial configuration, runs and energies of a study.
std::string conditions(const Config& config) {
  const ForceSettings& f = config.forces;
  const std::string mixing = description(f.mixing);
  return fmt::format(
      "{}, switched from {:g} to {:g} nm (class C{}){}, initial configuration {}; at most {} runs "
      "of {:g} ps from initial configurations equilibrated for {:g} ps at {:g} K, the same for "
      "every scheme; energies are sampled at least every 2.5 fs, or at every step{}; a curve ends "
      "at the step beyond which the energy drifts at every step; a drift has a p-value below {:g} "
      "and, during a run, changes the energy by at least {:g} times its rms fluctuation",
      f.truncation == Truncation::molecule_switch ? "molecule-based cutoff" : "site-based cutoff",
      f.switch_from, f.cutoff, f.smoothness, mixing.empty() ? "" : ", " + mixing,
      config.system.initial_configuration.empty() ? "lattice" : config.system.initial_configuration,
      config.study.runs, config.study.length, config.study.decorrelate, config.system.temperature,
      config.output.processed ? ", and read through postprocessors at a cost that is not counted"
                              : "",
      significance, drift_bound);
}

/// Advice from a study as text, such as "for R = 0.5 % use SCHEME at H fs: N force evaluations per
/// ps, Xx cheaper than velocity Verlet".
std::string advice(const StudyReport& report, double ratio) {
  const Guideline line = guidelines(report.curves, {ratio})[0];
  if (!line.best)
    return fmt::format("no scheme reaches R = {:g} % for this system without energy drift",
                       100 * ratio);
  const CostAtRatio& best = *line.costs[*line.best];
  std::string text = fmt::format(
      "for R = {:g} % use {} at {:.2g} fs: {:.0f} force evaluations per ps", 100 * ratio,
      report.curves[*line.best].scheme, best.step * units::fs_per_ps, best.cost);
  for (std::size_t c = 0; c < report.curves.size(); ++c)
    if (report.curves[c].scheme == "velocity-verlet" && line.costs[c] && c != *line.best)
      text +=
          fmt::format(", {:.2f}x cheaper than velocity Verlet", line.costs[c]->cost / best.cost);
  return text;
}

}  // namespace

StudyReport::StudyReport(const Config& config_used,
                         const std::vector<EfficiencyPoint>& points_found)
    : config(config_used),
      points(points_found),
      curves(polhode::curves(points)),
      guidelines(polhode::guidelines(curves, table_ratios)),
      claims(paper_claims(curves)),
      equipartition(polhode::equipartition(curves)) {}

Quantities quantities(const StudyReport& report) {
  const std::string answer = advice(report, 0.005);
  Quantities list = {
      {"conditions", "", conditions(report.config), "conditions that all runs have in common"},
      detail(row("", conditions(report.config))),
      detail({"points", "", point_records(report), "results for each scheme and step", "points"}),
      of_guidelines(report)};
  for (const Quantity& table : temperature_tables(report.curves, report.equipartition))
    list.push_back(detail(table));
  append(list, limits(report.equipartition));
  append(list, of_claims(report));
  append(list, {{"advice", "", answer, "cheapest scheme for R = 0.5 %", "recommendation"},
                row_of_files(report.files)});
  return list;
}

StudyReport run_study(const Config& config, const std::string& record, const std::string& prefix,
                      const OutputOptions& options, const Callbacks& callbacks, Workers& workers) {
  const EnergyStudy study{config};
  return StudyJob(study, prefix, options, callbacks).perform(record, workers);
}

}  // namespace polhode
