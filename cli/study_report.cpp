// SPDX-License-Identifier: MIT
#include "study_report.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "polhode/io/plot.hpp"

namespace polhode::cli {
namespace {

// R at which the guideline table gives costs, the paper's limits among them.
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
                   {"drift_chance", "1"},
                   {"temperature", "K"},
                   {"R_rounding", "1"},
                   {"rounded", "1"},
                   {"near_weight", "1"}};
  for (const char* axis : {"1", "2", "3"}) {
    table.columns.push_back({fmt::format("excess_{}", axis), "K"});
    table.columns.push_back({fmt::format("excess_{}_error", axis), "K"});
  }
  for (const char* motion : {"translation", "1", "2", "3"}) {
    table.columns.push_back({fmt::format("configurational_excess_{}", motion), "K"});
    table.columns.push_back({fmt::format("configurational_excess_{}_error", motion), "K"});
  }
  for (const Curve& curve : report.curves)
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      const EfficiencyPoint& p = curve.points[i];
      table.rows.push_back({p.scheme, p.step * 1000, p.cost, static_cast<double>(p.runs),
                            p.stable ? 1.0 : 0.0, i < curve.usable ? 1.0 : 0.0, p.ratio.value,
                            p.ratio.error, p.drift.rate.value, p.drift.rate.error, p.drift.chance,
                            p.temperature, p.rounding, p.at_rounding() ? 1.0 : 0.0, p.near_weight});
      const auto add = [&](const std::optional<Estimate>& excess) {
        const Estimate known = excess.value_or(Estimate{std::nan(""), std::nan("")});
        table.rows.back().insert(table.rows.back().end(), {known.value, known.error});
      };
      for (const auto& excess : p.excess) add(excess);
      for (const auto& excess : p.configurational_excess) add(excess);
    }
  return table;
}

std::string conditions(const Config& config) {
  const ForceSettings& f = config.forces;
  const std::string mixing = described(f.mixing);
  return fmt::format(
      "{}, switched from {:g} to {:g} nm (class C{}){}, start {}; {} or more runs of {:g} ps from "
      "starts "
      "prepared "
      "for {:g} ps at {:g} K, the same for every scheme; energies at least every 2.5 fs or every "
      "step; "
      "drift significant below a chance of {:g}",
      f.truncation == Truncation::molecule_switch ? "molecule-based cutoff" : "site-based cutoff",
      f.switch_from, f.cutoff, f.smoothness, mixing.empty() ? "" : ", " + mixing,
      config.system.start.empty() ? "lattice" : config.system.start, config.study.runs,
      config.study.length, config.study.decorrelate, config.system.temperature, significance);
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
    return fmt::format("no scheme reaches R = {:g} % here without drift", 100 * ratio);
  const CostAtRatio& best = *line.costs[*line.best];
  std::string text =
      fmt::format("for R = {:g} % use {} at {:.2g} fs: {:.0f} force evaluations per ps",
                  100 * ratio, report.curves[*line.best].scheme, best.step * 1000, best.cost);
  for (std::size_t c = 0; c < report.curves.size(); ++c)
    if (report.curves[c].scheme == "velocity-verlet" && line.costs[c] && c != *line.best)
      text +=
          fmt::format(", {:.2f} times fewer than velocity Verlet", line.costs[c]->cost / best.cost);
  return text;
}

namespace {

nlohmann::json estimate_json(const std::optional<Estimate>& e) {
  if (!e) return {};
  return {{"value", e->value}, {"error", e->error}};
}

}  // namespace

std::string study_json(const StudyReport& report) {
  nlohmann::json json;
  json["conditions"] = conditions(report.config);
  for (const Curve& curve : report.curves)
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      const EfficiencyPoint& p = curve.points[i];
      json["points"].push_back({{"scheme", p.scheme},
                                {"step_fs", p.step * 1000},
                                {"force_evaluations_per_ps", p.cost},
                                {"runs", p.runs},
                                {"stable", p.stable},
                                {"usable", i < curve.usable},
                                {"R", p.ratio.value},
                                {"R_error", p.ratio.error},
                                {"drift_kJ_per_mol_ps", p.drift.rate.value},
                                {"drift_error", p.drift.rate.error},
                                {"drift_chance", p.drift.chance},
                                {"temperature_K", p.temperature},
                                {"R_rounding", p.rounding},
                                {"rounded", p.at_rounding()},
                                {"near_weight", p.near_weight}});
      for (const auto& excess : p.excess)
        json["points"].back()["excess_K"].push_back(estimate_json(excess));
      for (const auto& excess : p.configurational_excess)
        json["points"].back()["configurational_excess_K"].push_back(estimate_json(excess));
    }
  const auto add = [&](const char* kind, const std::string& scheme, nlohmann::json motion,
                       int order, const Line& line) {
    json[kind].push_back({{"scheme", scheme},
                          {"axis", std::move(motion)},
                          {"order", order},
                          {"without_step_K", line.intercept.value},
                          {"without_step_error", line.intercept.error},
                          {"slope_K_per_ps_to_the_order", line.slope.value},
                          {"slope_error", line.slope.error}});
  };
  for (const EquipartitionFit& fit : report.equipartition) {
    for (std::size_t k = 0; k < fit.axes.size(); ++k)
      if (fit.axes[k]) add("equipartition", fit.scheme, k + 1, fit.order, *fit.axes[k]);
    for (std::size_t k = 0; k < fit.configurational.size(); ++k)
      if (fit.configurational[k])
        add("configurational", fit.scheme, k == 0 ? nlohmann::json() : nlohmann::json(k), fit.order,
            *fit.configurational[k]);
  }
  for (const Guideline& line : report.guidelines) {
    nlohmann::json row{{"R", line.ratio}};
    for (std::size_t c = 0; c < line.costs.size(); ++c)
      if (line.costs[c])
        row["costs"][report.curves[c].scheme] = {{"force_evaluations_per_ps", line.costs[c]->cost},
                                                 {"error", line.costs[c]->error},
                                                 {"step_fs", line.costs[c]->step * 1000},
                                                 {"extrapolated", line.costs[c]->extrapolated},
                                                 {"longest_without_drift", line.costs[c]->longest}};
    if (line.best) row["best"] = report.curves[*line.best].scheme;
    json["guidelines"].push_back(row);
  }
  for (const Claim& claim : report.claims) {
    nlohmann::json row{{"claim", claim.text}, {"verdict", claim.reproduced}};
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
  std::vector<EfficiencyCurve> drawn;
  for (const Curve& curve : report.curves) {
    drawn.push_back({curve.scheme, {}});
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      const EfficiencyPoint& p = curve.points[i];
      drawn.back().marks.push_back(
          {p.cost, p.ratio.value, p.ratio.error, i < curve.usable, p.at_rounding()});
    }
  }
  for (const char* format : {"svg", "png"}) efficiency_plot(files.prefix, drawn, format, std::cerr);
}

namespace {

/// Differences of temperatures by scheme and step, and without a step; nothing if none is known.
/// @param columns  of what the differences are
/// @param at       the differences at a point
/// @param limits   the lines through them
template <std::size_t n>
void print_excesses(const StudyReport& report, const char* title,
                    const std::array<const char*, n>& columns, const auto& at, const auto& limits) {
  const auto known = [&](const EfficiencyPoint& p) {
    return std::any_of(at(p).begin(), at(p).end(), [](const auto& e) { return e.has_value(); });
  };
  if (std::none_of(report.points.begin(), report.points.end(), known)) return;
  const auto text = [](const std::optional<Estimate>& e) {
    return e ? fmt::format("{:.2f} ± {:.2f}", e->value, e->error) : "-";
  };
  fmt::print("\n{} [K], and without a step by a + b h^k\n{:<18} {:>8}", title, "scheme", "step fs");
  for (const char* column : columns) fmt::print(" {:>16}", column);
  fmt::print("\n");
  for (std::size_t c = 0; c < report.curves.size(); ++c) {
    const Curve& curve = report.curves[c];
    for (std::size_t i = 0; i < curve.usable; ++i) {
      const EfficiencyPoint& p = curve.points[i];
      fmt::print("{:<18} {:>8.3g}", p.scheme, p.step * 1000);
      for (const auto& excess : at(p)) fmt::print(" {:>16}", text(excess));
      fmt::print("\n");
    }
    const EquipartitionFit& fit = report.equipartition[c];
    fmt::print("{:<18} {:>8}", "", fmt::format("0, k = {}", fit.order));
    for (const std::optional<Line>& line : limits(fit))
      fmt::print(" {:>16}", text(line ? std::optional(line->intercept) : std::nullopt));
    fmt::print("\n");
  }
}

void print_equipartition(const StudyReport& report) {
  print_excesses<3>(
      report, "temperature of rotation about each principal axis less that of translation",
      {"axis 1", "axis 2", "axis 3"},
      [](const EfficiencyPoint& p) -> const auto& { return p.excess; },
      [](const EquipartitionFit& fit) -> const auto& { return fit.axes; });
  print_excesses<4>(
      report, "configurational temperature of each motion less its kinetic one",
      {"translation", "axis 1", "axis 2", "axis 3"},
      [](const EfficiencyPoint& p) -> const auto& { return p.configurational_excess; },
      [](const EquipartitionFit& fit) -> const auto& { return fit.configurational; });
}

}  // namespace

void print_study(const StudyReport& report, const StudyFiles& files) {
  fmt::print("{}\n\n", conditions(report.config));
  fmt::print("{:<18} {:>8} {:>10} {:>5} {:>18} {:>24}  {}\n", "scheme", "step fs", "cost 1/ps",
             "runs", "R %", "drift kJ/mol/ps", "");
  for (const Curve& curve : report.curves)
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      const EfficiencyPoint& p = curve.points[i];
      const std::string note = !p.stable                       ? "blew up"
                               : p.drift.chance < significance ? "drift significant"
                               : i >= curve.usable             ? "beyond the end of stability"
                               : p.at_rounding()
                                   ? fmt::format("rounding alone makes {:.2g} %", 100 * p.rounding)
                                   : "";
      fmt::print("{:<18} {:>8.3g} {:>10.0f} {:>5} {:>18} {:>24}  {}\n", p.scheme, p.step * 1000,
                 p.cost, p.runs,
                 fmt::format("{:.4g} ± {:.2g}", 100 * p.ratio.value, 100 * p.ratio.error),
                 fmt::format("{:.3g} ± {:.2g}", p.drift.rate.value, p.drift.rate.error), note);
    }

  fmt::print(
      "\nleast cost for an R at or below the one given, in force evaluations per ps (ratio to "
      "velocity "
      "Verlet);\n* extrapolated by the scheme's order, + the longest step without drift\n{:>8}",
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
        text = cost->longest ? fmt::format("{:.0f}+", cost->cost)
                             : fmt::format("{:.0f} ± {:.0f}{}", cost->cost, cost->error,
                                           cost->extrapolated ? "*" : "");
        if (verlet < line.costs.size() && line.costs[verlet])
          text += fmt::format(" ({:.2f})", line.costs[verlet]->cost / cost->cost);
      }
      fmt::print(" {:>22}", text);
    }
    fmt::print("  {}\n", line.best ? report.curves[*line.best].scheme : "none");
  }
  print_equipartition(report);
  const auto& molecules = report.config.system.molecules;
  const bool of_the_paper =
      molecules.size() == 1 && molecules[0].model == "tip4p" && molecules[0].count == 512;
  if (!report.claims.empty())
    fmt::print("\nthe paper's claims (vanzon2008){}\n",
               of_the_paper ? "" : "; they are of 512 TIP4P waters, not of this system");
  for (const Claim& claim : report.claims)
    fmt::print(
        "  {}{}: {}\n", claim.text,
        claim.value ? fmt::format(": {:.3g} ± {:.2g}", claim.value->value, claim.value->error) : "",
        claim.reproduced);
  fmt::print("\n{}\nfiles {}\n", advice(report, 0.005), fmt::join(files.all(), " "));
}

}  // namespace polhode::cli
