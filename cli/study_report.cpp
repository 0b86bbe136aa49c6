// SPDX-License-Identifier: MIT
#include "study_report.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "polhode/io/output_units.hpp"
#include "polhode/io/plot.hpp"
#include "temperature_tables.hpp"

namespace polhode::cli {
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
                   {"temperature", "K"},
                   {"R_rounding", "1"},
                   {"rounded", "1"},
                   {"near_weight", "1"}};
  add_excess_columns(table.columns);
  for (const Curve& curve : report.curves)
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      const EfficiencyPoint& p = curve.points[i];
      table.rows.push_back({p.scheme, p.step * units::fs_per_ps, p.cost,
                            static_cast<double>(p.runs), p.stable ? 1.0 : 0.0,
                            i < curve.usable ? 1.0 : 0.0, p.ratio.value, p.ratio.error,
                            p.drift.rate.value, p.drift.rate.error, p.drift.p_value, p.temperature,
                            p.rounding, p.at_rounding() ? 1.0 : 0.0, p.near_weight});
      add_excesses(table.rows.back(), p);
    }
  return table;
}

std::string conditions(const Config& config) {
  const ForceSettings& f = config.forces;
  const std::string mixing = description(f.mixing);
  return fmt::format(
      "{}, switched from {:g} to {:g} nm (class C{}){}, initial configuration {}; at most {} runs "
      "of {:g} ps from initial configurations equilibrated for {:g} ps at {:g} K, the same for "
      "every scheme; energies at least every 2.5 fs or every step; drift significant below a "
      "p-value of {:g}",
      f.truncation == Truncation::molecule_switch ? "molecule-based cutoff" : "site-based cutoff",
      f.switch_from, f.cutoff, f.smoothness, mixing.empty() ? "" : ", " + mixing,
      config.system.initial_configuration.empty() ? "lattice" : config.system.initial_configuration,
      config.study.runs, config.study.length, config.study.decorrelate, config.system.temperature,
      significance);
}

/// A mean over runs, with its error if there are enough of them.
std::string with_error(const Estimate& e, int digits, int runs) {
  if (!std::isfinite(e.value)) return "-";
  const std::string value = fmt::format("{:.{}g}", e.value, digits);
  return runs > 1 ? fmt::format("{} ± {:.2g}", value, e.error) : value;
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

std::string advice(const StudyReport& report, double ratio) {
  const Guideline line = guidelines(report.curves, {ratio})[0];
  if (!line.best)
    return fmt::format("no scheme reaches R = {:g} % for this system without drift", 100 * ratio);
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
  for (const Curve& curve : report.curves)
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      const EfficiencyPoint& p = curve.points[i];
      const auto error_of = [&](const Estimate& e) {  // not known from one run
        return p.runs > 1 && std::isfinite(e.error) ? nlohmann::json(e.error) : nlohmann::json();
      };
      json["points"].push_back(
          {{"scheme", p.scheme},
           {"step_fs", p.step * units::fs_per_ps},
           {"force_evaluations_per_ps", p.cost},
           {"runs", p.runs},
           {"stable", p.stable},
           {"usable", i < curve.usable},
           {"R", p.ratio.value},
           {"R_error", error_of(p.ratio)},
           {"drift_kJ_per_mol_ps", p.drift.rate.value},
           {"drift_error", error_of(p.drift.rate)},
           {"drift_p_value", p.runs > 1 ? nlohmann::json(p.drift.p_value) : nlohmann::json()},
           {"temperature_K", p.temperature},
           {"R_rounding", p.rounding},
           {"rounded", p.at_rounding()},
           {"near_weight", p.near_weight}});
      add_excesses(json["points"].back(), p);
    }
  add_limits(json, report.equipartition);
  for (const Guideline& line : report.guidelines) {
    nlohmann::json row{{"R", line.ratio}};
    for (std::size_t c = 0; c < line.costs.size(); ++c)
      if (line.costs[c])
        row["costs"][report.curves[c].scheme] = {
            {"force_evaluations_per_ps", line.costs[c]->cost},
            {"error", line.costs[c]->error},
            {"step_fs", line.costs[c]->step * units::fs_per_ps},
            {"extrapolated", line.costs[c]->extrapolated},
            {"max_step_without_drift", line.costs[c]->at_max_step}};
    if (line.best) row["best"] = report.curves[*line.best].scheme;
    json["guidelines"].push_back(row);
  }
  for (const Claim& claim : report.claims) {
    nlohmann::json row{{"claim", claim.text}, {"verdict", in_words(claim.verdict)}};
    if (claim.value) row["value"] = claim.value->value, row["error"] = claim.value->error;
    json["claims"].push_back(row);
  }
  json["advice"] = advice(report, 0.005);
  return json.dump(2);
}

void write_study(const StudyFiles& files, const StudyReport& report, const Provenance& provenance) {
  write_file(files.points,
             [&](std::ostream& out) { write_csv(out, point_table(report), provenance); });
  write_file(files.json, [&](std::ostream& out) { out << study_json(report) << '\n'; });
  std::vector<EfficiencyCurve> figure_data;
  for (const Curve& curve : report.curves) {
    figure_data.push_back({curve.scheme, {}});
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      const EfficiencyPoint& p = curve.points[i];
      figure_data.back().marks.push_back(
          {p.cost, p.ratio.value, p.ratio.error, i < curve.usable, p.at_rounding()});
    }
  }
  for (const char* format : {"svg", "png"})
    efficiency_plot(files.prefix, figure_data, format, std::cerr);
}

void print_study(const StudyReport& report, const std::vector<std::string>& written) {
  fmt::print("{}\n\n", conditions(report.config));
  fmt::print("{:<18} {:>8} {:>10} {:>5} {:>18} {:>24}  {}\n", "scheme", "step fs", "cost 1/ps",
             "runs", "R %", "drift kJ/mol/ps", "");
  for (const Curve& curve : report.curves)
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      const EfficiencyPoint& p = curve.points[i];
      const std::string note = !p.stable               ? "blew up"
                               : p.drift.significant() ? "drift significant"
                               : i >= curve.usable     ? "unstable"
                               : p.at_rounding()
                                   ? fmt::format("rounding alone gives {:.2g} %", 100 * p.rounding)
                                   : "";
      fmt::print("{:<18} {:>8.3g} {:>10.0f} {:>5} {:>18} {:>24}  {}\n", p.scheme,
                 p.step * units::fs_per_ps, p.cost, p.runs,
                 with_error({100 * p.ratio.value, 100 * p.ratio.error}, 4, p.runs),
                 with_error(p.drift.rate, 3, p.runs), note);
    }

  fmt::print(
      "\nminimum cost for an R at or below the given one, in force evaluations per ps (ratio to "
      "velocity Verlet);\n* extrapolated by the scheme's order, + the maximum step without "
      "drift\n{:>8}",
      "R %");
  for (const Curve& curve : report.curves) fmt::print(" {:>22}", curve.scheme);
  fmt::print("  best\n");
  std::size_t verlet = report.curves.size();
  for (std::size_t c = 0; c < report.curves.size(); ++c)
    if (report.curves[c].scheme == "velocity-verlet") verlet = c;
  for (const Guideline& line : report.guidelines) {
    fmt::print("{:>8g}", 100 * line.ratio);
    for (std::size_t c = 0; c < line.costs.size(); ++c) {
      const auto& cost = line.costs[c];
      std::string text = "-";
      if (cost) {
        text = cost->at_max_step ? fmt::format("{:.0f}+", cost->cost)
                                 : fmt::format("{:.0f} ± {:.0f}{}", cost->cost, cost->error,
                                               cost->extrapolated ? "*" : "");
        if (verlet < line.costs.size() && line.costs[verlet])
          text += fmt::format(" ({:.2f})", line.costs[verlet]->cost / cost->cost);
      }
      fmt::print(" {:>22}", text);
    }
    fmt::print("  {}\n", line.best ? report.curves[*line.best].scheme : "none");
  }
  print_temperatures(report.curves, report.equipartition);
  const auto& molecules = report.config.system.molecules;
  const bool of_the_paper =
      molecules.size() == 1 && molecules[0].model == "tip4p" && molecules[0].count == 512;
  if (!report.claims.empty())
    fmt::print("\nthe paper's claims [vanzon2008]{}\n",
               of_the_paper ? "" : "; they refer to 512 TIP4P waters, not to this system");
  for (const Claim& claim : report.claims)
    fmt::print(
        "  {}{}: {}\n", claim.text,
        claim.value ? fmt::format(": {:.3g} ± {:.2g}", claim.value->value, claim.value->error) : "",
        in_words(claim.verdict));
  fmt::print("\n{}\nfiles {}\n", advice(report, 0.005), fmt::join(written, " "));
}

}  // namespace polhode::cli
