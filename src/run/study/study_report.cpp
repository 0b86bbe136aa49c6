// SPDX-License-Identifier: MIT
#include "run/study/study_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/settings/output_units.hpp"
#include "polhode/base/error.hpp"
#include "polhode/io/figures/plot.hpp"
#include "run/simulation/system/near_forces.hpp"
#include "run/study/study_record.hpp"
#include "study_job.hpp"
#include "temperature_differences.hpp"

namespace polhode {
namespace {

// Values of R for which the guideline table lists costs, including those of the paper.
const std::vector<double> table_ratios = {0.03, 0.015, 0.01, 0.007, 0.004, 0.002, 0.001, 0.0001};

Table point_table(const StudyReport& report) {
  Table table;
  table.columns = {{"scheme", ""},
                   {"step", "fs"},
                   {"cost", "1/ps"},
                   {"runs", "1"},
                   {"stable", "1"},
                   {"usable", "1"},
                   {"R", "1"},
                   {"R_error", "1"},
                   {"drift", "kJ/mol/ps"},
                   {"drift_error", "kJ/mol/ps"},
                   {"drift_p_value", "1"},
                   {"relative_drift", "1"},
                   {"temperature", "K"},
                   {"R_rounding", "1"},
                   {"rounded", "1"},
                   {"near_weight", "1"}};
  add_excess_columns(table.columns);
  for (const Curve& curve : report.curves)
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      const EfficiencyPoint& p = curve.points[i];
      table.rows.push_back(
          {p.scheme, p.step * units::fs_per_ps, p.cost, static_cast<double>(p.runs),
           p.stable ? 1.0 : 0.0, i < curve.usable ? 1.0 : 0.0, p.ratio.value, p.ratio.error,
           p.drift.rate.value, p.drift.rate.error, p.drift.p_value, p.relative_drift(),
           p.temperature, p.rounding, p.at_rounding() ? 1.0 : 0.0, p.near_weight});
      add_excesses(table.rows.back(), p);
    }
  return table;
}

nlohmann::json as_json(const EfficiencyPoint& p, bool usable) {
  const auto error_of = [&](const Estimate& e) {  // not known from one run
    return p.runs > 1 && std::isfinite(e.error) ? nlohmann::json(e.error) : nlohmann::json();
  };
  nlohmann::json json{
      {"scheme", p.scheme},
      {"step_fs", p.step * units::fs_per_ps},
      {"force_evaluations_per_ps", p.cost},
      {"runs", p.runs},
      {"stable", p.stable},
      {"usable", usable},
      {"R", p.ratio.value},
      {"R_error", error_of(p.ratio)},
      {"drift_kJ_per_mol_ps", p.drift.rate.value},
      {"drift_error", error_of(p.drift.rate)},
      {"drift_p_value", p.runs > 1 ? nlohmann::json(p.drift.p_value) : nlohmann::json()},
      {"relative_drift", p.relative_drift()},
      {"temperature_K", p.temperature},
      {"R_rounding", p.rounding},
      {"rounded", p.at_rounding()},
      {"near_weight", p.near_weight}};
  add_excesses(json, p);
  return json;
}

nlohmann::json as_json(const Guideline& line, const std::vector<Curve>& curves) {
  nlohmann::json row{{"R", line.ratio}};
  for (std::size_t c = 0; c < line.costs.size(); ++c)
    if (line.costs[c])
      row["costs"][curves[c].scheme] = {{"force_evaluations_per_ps", line.costs[c]->cost},
                                        {"error", line.costs[c]->error},
                                        {"step_fs", line.costs[c]->step * units::fs_per_ps},
                                        {"extrapolated", line.costs[c]->extrapolated},
                                        {"max_step_without_drift", line.costs[c]->at_max_step}};
  if (line.best) row["best"] = curves[*line.best].scheme;
  return row;
}

nlohmann::json as_json(const Claim& claim) {
  nlohmann::json row{{"claim", claim.text}, {"verdict", in_words(claim.verdict)}};
  if (claim.value) row["value"] = claim.value->value, row["error"] = claim.value->error;
  return row;
}

/// What a reader of the figure needs to know to compare the curves.
std::string caption(const Config& config) {
  std::string molecules;
  for (const auto& component : config.system.molecules)
    molecules +=
        fmt::format("{}{} {}", molecules.empty() ? "" : ", ", component.count, component.model);
  return fmt::format(
      "Lower and further left is better; R = 0 is exact dynamics. {}; {} runs of {:g} ps per "
      "point.",
      molecules.empty() ? config.source : molecules, config.study.runs, config.study.length);
}

EfficiencyFigure figure(const StudyReport& report) {
  EfficiencyFigure figure{{}, caption(report.config)};
  for (const Curve& curve : report.curves) {
    figure.curves.push_back({curve.scheme, {}});
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      const EfficiencyPoint& p = curve.points[i];
      figure.curves.back().marks.push_back(
          {p.cost, p.ratio.value, p.ratio.error, i < curve.usable, p.at_rounding()});
    }
  }
  return figure;
}

/// The study of energy conservation.
struct EnergyStudy {
  using Run = StudyRun;
  using Record = StudyRecord;
  using Report = StudyReport;

  static constexpr const char* title = "study";
  static constexpr auto identity = study_identity;
  static constexpr auto perform = perform_study_runs;
  static constexpr auto table_of = point_table;
  static constexpr auto figure_of = figure;
  static constexpr auto plot = efficiency_plot;

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
    }
  }

  void note(const Callbacks& callbacks) const {
    note_constant_energy(config, "the study", callbacks);
  }

  StudyReport report(const System& system, const std::vector<StudyRun>& runs) const {
    Config used = config;
    used.forces.mixing = system.forces.mixing;  // known after the topology file is read
    return {used, efficiency_points(all, runs, config.study.length)};
  }
};

}  // namespace

std::string conditions(const Config& config) {
  const ForceSettings& f = config.forces;
  const std::string mixing = description(f.mixing);
  return fmt::format(
      "{}, switched from {:g} to {:g} nm (class C{}){}, initial configuration {}; at most {} runs "
      "of {:g} ps from initial configurations equilibrated for {:g} ps at {:g} K, the same for "
      "every scheme; energies at least every 2.5 fs or every step; a curve ends where the energy "
      "drifts at all longer steps: with a p-value below {:g}, and during a run by at least {:g} "
      "rms fluctuation of the energy",
      f.truncation == Truncation::molecule_switch ? "molecule-based cutoff" : "site-based cutoff",
      f.switch_from, f.cutoff, f.smoothness, mixing.empty() ? "" : ", " + mixing,
      config.system.initial_configuration.empty() ? "lattice" : config.system.initial_configuration,
      config.study.runs, config.study.length, config.study.decorrelate, config.system.temperature,
      significance, drift_bound);
}

StudyReport::StudyReport(const Config& config_used,
                         const std::vector<EfficiencyPoint>& points_found)
    : config(config_used),
      points(points_found),
      curves(polhode::curves(points)),
      guidelines(polhode::guidelines(curves, table_ratios)),
      claims(paper_claims(curves)),
      equipartition(polhode::equipartition(curves)) {}

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
          fmt::format(", {:.2f} times fewer than velocity Verlet", line.costs[c]->cost / best.cost);
  return text;
}

std::string study_json(const StudyReport& report) {
  nlohmann::json json;
  json["conditions"] = conditions(report.config);
  json["points"] = nlohmann::json::array();
  for (const Curve& curve : report.curves)
    for (std::size_t i = 0; i < curve.points.size(); ++i)
      json["points"].push_back(as_json(curve.points[i], i < curve.usable));
  add_limits(json, report.equipartition);
  for (const Guideline& line : report.guidelines)
    json["guidelines"].push_back(as_json(line, report.curves));
  for (const Claim& claim : report.claims) json["claims"].push_back(as_json(claim));
  json["advice"] = advice(report, 0.005);
  return json.dump(2);
}

StudyReport run_study(const Config& config, const std::string& prefix, const OutputOptions& options,
                      const Callbacks& callbacks, Workers& workers) {
  const EnergyStudy study{config};
  return StudyJob(study, prefix, options, callbacks).run(workers);
}

StudyReport report_study_record(const Config& config, const std::string& record,
                                const std::string& prefix, const OutputOptions& options,
                                const Callbacks& callbacks) {
  const EnergyStudy study{config};
  return StudyJob(study, prefix, options, callbacks).from(record);
}

}  // namespace polhode
