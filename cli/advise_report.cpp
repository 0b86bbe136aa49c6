// SPDX-License-Identifier: MIT
#include "advise_report.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "polhode/integrate/scheme_text.hpp"
#include "polhode/io/output_units.hpp"
#include "polhode/io/plot.hpp"
#include "polhode/io/quantity.hpp"
#include "polhode/run/adviser/advice_curves.hpp"
#include "temperature_tables.hpp"

namespace polhode::cli {
namespace {

constexpr const char* kinds[] = {"translation", "rotation_1", "rotation_2", "rotation_3"};

double in_kJ_per_ns(double power) { return power / unit("kJ/mol/ns", Dimension::power); }

std::string percent(const Estimate& x) {
  return fmt::format("{:.3g} ± {:.2g} %", 100 * x.value, 100 * x.error);
}

/// A bound on the quality, in the unit that users enter.
std::string bound_text(Quality quality, double bound) {
  return quality == Quality::drift ? fmt::format("{:.3g} kJ/mol/ns", in_kJ_per_ns(bound))
                                   : fmt::format("{:.3g} %", 100 * bound);
}

const char* name_of(Quality quality) {
  switch (quality) {
    case Quality::ratio:
      return "R";
    case Quality::drift:
      return "drift";
    case Quality::temperature_bias:
      return "temperature bias";
  }
  return "";
}

/// T_k/T − 1 of one kind of motion; 0 without degrees of freedom.
Estimate bias(const AdviserPoint& point, std::size_t kind) {
  return mean(each(point.runs, [kind](const Outcome& run) { return run.bias[kind]; }));
}

double worst_rounding(const AdviserPoint& point) {
  const auto values = each(point.runs, [](const Outcome& run) { return run.rounding; });
  return *std::max_element(values.begin(), values.end());
}

nlohmann::json as_json(const Candidate& candidate, const AdviserPoint& point) {
  nlohmann::json json{{"step_fs", point.step * units::fs_per_ps},
                      {"runs", point.runs.size()},
                      {"length_ps", point.length},
                      {"blew_up", blew_up(point.runs)},
                      {"usable", point.usable}};
  if (blew_up(point.runs)) return json;
  json["bound"] = point.bound;
  json["R"] = point.ratio().value;
  json["R_error"] = point.ratio().error;
  json["drift_per_molecule_kJ_per_mol_ns"] = in_kJ_per_ns(point.drift().value);
  json["drift_error"] = in_kJ_per_ns(point.drift().error);
  for (std::size_t k = 0; k < 4; ++k) {
    if (bias(point, k).error == 0) continue;
    json["temperature_bias"][kinds[k]] = {{"value", bias(point, k).value},
                                          {"error", bias(point, k).error}};
  }
  add_excesses(json, efficiency_point(candidate, point));
  json["R_rounding"] = worst_rounding(point);
  return json;
}

nlohmann::json as_json(const Candidate& candidate) {
  nlohmann::json json{{"scheme", candidate.name},
                      {"text", text_of(candidate.scheme)},
                      {"step_fs", candidate.step * units::fs_per_ps},
                      {"ns_per_day", candidate.ns_per_day()},
                      {"points", nlohmann::json::array()}};
  if (candidate.step > 0)
    json["force_evaluations_per_ps"] = candidate.scheme.cost() / candidate.step;
  if (!candidate.obstacle.empty()) json["obstacle"] = candidate.obstacle;
  for (const AdviserPoint& point : candidate.points)
    json["points"].push_back(as_json(candidate, point));
  return json;
}

Table point_table(const Advice& advice) {
  Table table;
  table.columns = {{"scheme", ""},
                   {"step", "fs"},
                   {"length", "ps"},
                   {"runs", "1"},
                   {"usable", "1"},
                   {"R", "1"},
                   {"R_error", "1"},
                   {"drift_per_molecule", "kJ/mol/ns"},
                   {"drift_error", "kJ/mol/ns"},
                   {"bound", "1"},
                   {"confirms", "1"}};
  add_excess_columns(table.columns);
  const auto add = [&](const Candidate& candidate, const AdviserPoint& p, bool confirms) {
    const bool there = !blew_up(p.runs);
    const Estimate R = there ? p.ratio() : Estimate{}, d = there ? p.drift() : Estimate{};
    table.rows.push_back({candidate.name, p.step * units::fs_per_ps, p.length,
                          static_cast<double>(p.runs.size()), p.usable ? 1.0 : 0.0, R.value,
                          R.error, in_kJ_per_ns(d.value), in_kJ_per_ns(d.error),
                          there ? p.bound : 0.0, confirms ? 1.0 : 0.0});
    add_excesses(table.rows.back(), efficiency_point(candidate, p));
  };
  for (const Candidate& candidate : advice.candidates)
    for (const AdviserPoint& point : candidate.points) add(candidate, point, false);
  for (const auto* sets : {&advice.refused, &advice.surpassed})
    for (const auto& [c, point] : *sets) add(advice.candidates[c], point, true);
  if (advice.best) add(advice.candidates[*advice.best], advice.confirmation, true);
  return table;
}

std::vector<AdviceCurve> figure_curves(const Advice& advice) {
  std::vector<AdviceCurve> figure_data;
  for (const Candidate& candidate : advice.candidates) {
    if (candidate.seconds == 0) continue;
    AdviceCurve curve{candidate.name, {}, {}};
    const auto seconds = [&](double step) { return candidate.seconds * candidate.step / step; };
    for (const AdviserPoint& p : candidate.points)
      if (p.usable) curve.marks.push_back({seconds(p.step), p.ratio().value, p.ratio().error});
    if (candidate.model)
      for (double step = 0.7 * candidate.step; step < 1.25 * candidate.step; step *= 1.02)
        curve.model.push_back({seconds(step), std::exp(candidate.model->log_ratio(step).value)});
    figure_data.push_back(curve);
  }
  return figure_data;
}

}  // namespace

AdviceFiles::AdviceFiles(const std::string& common, const std::string& plot)
    : prefix(common), points(prefix + ".csv"), json(prefix + ".json") {
  if (plot == "none") return;
  script = prefix + ".gp";
  figure = prefix + "." + plot;
}

std::vector<std::string> AdviceFiles::all() const {
  std::vector<std::string> files = {points, json};
  if (!figure.empty()) files.insert(files.end(), {script, figure});
  return files;
}

std::string description(const Criterion& criterion) {
  return fmt::format("{} {} of at most {}", criterion.quality == Quality::ratio ? "an" : "a",
                     name_of(criterion.quality), bound_text(criterion.quality, criterion.bound));
}

std::string unreachable(const Advice& advice, const Criterion& criterion) {
  const Candidate* best = nullptr;
  const AdviserPoint* reached = nullptr;
  const auto consider = [&](const Candidate& candidate, const AdviserPoint& point) {
    if (!point.usable || (reached && reached->bound <= point.bound)) return;
    best = &candidate;
    reached = &point;
  };
  for (const Candidate& candidate : advice.candidates)
    for (const AdviserPoint& point : candidate.points) consider(candidate, point);
  for (const auto& [c, point] : advice.refused) consider(advice.candidates[c], point);
  std::string text =
      fmt::format("no scheme was found that meets {} for this system", description(criterion));
  if (!reached)
    return text +
           "; every step that was tried blew up or drifted: equilibrate longer, or check the "
           "initial configuration";
  text += fmt::format("; the smallest bound reached is {}, with {} at {:.3g} fs",
                      bound_text(criterion.quality, reached->bound), best->name,
                      reached->step * units::fs_per_ps);
  if (worst_rounding(*reached) > 0.5 * reached->ratio().value)
    text += fmt::format(
        "; rounding alone makes R = {:.2g} % in mixed precision; take precision = \"double\" to "
        "avoid it",
        100 * worst_rounding(*reached));
  if (criterion.quality != Quality::ratio)
    text += "; the bound includes the error of the mean, which a longer --time or --length reduces";
  return text;
}

std::string answer(const Advice& advice) {
  const AdviserPoint& p = advice.confirmation;
  return fmt::format("{} at {:.3g} fs, R = {} in {} independent runs of {:.3g} ps",
                     advice.candidates[*advice.best].name, p.step * units::fs_per_ps,
                     percent(p.ratio()), p.runs.size(), p.length);
}

void write_advice(const AdviceFiles& files, const Advice& advice, const Criterion& criterion,
                  const Provenance& provenance) {
  write_file(files.points,
             [&](std::ostream& out) { write_csv(out, point_table(advice), provenance); });
  write_file(files.json,
             [&](std::ostream& out) { out << advice_json(advice, criterion, 0) << '\n'; });
  if (files.figure.empty()) return;
  AdviceFigure figure{figure_curves(advice), {}, {}};
  if (criterion.quality == Quality::ratio) figure.bound = criterion.bound;
  if (advice.best) {
    const Candidate& best = advice.candidates[*advice.best];
    figure.confirmed = {best.seconds, advice.confirmation.ratio().value,
                        advice.confirmation.ratio().error};
  }
  advice_plot(files.prefix, figure, files.figure.substr(files.prefix.size() + 1), std::cerr);
}

std::string advice_json(const Advice& advice, const Criterion& criterion, int threads) {
  nlohmann::json json{{"quality", name_of(criterion.quality)},
                      {"wanted", criterion.bound},
                      {"probability", guarantee_probability},
                      {"interrupted", advice.stopped},
                      {"candidates", nlohmann::json::array()},
                      {"refused", nlohmann::json::array()},
                      {"surpassed", nlohmann::json::array()},
                      {"best", nullptr},
                      {"runner_up", nullptr}};
  if (criterion.quality == Quality::drift)
    json["wanted"] = in_kJ_per_ns(criterion.bound), json["unit"] = "kJ/mol/ns per molecule";
  if (threads > 0) json["threads"] = threads;
  for (const Candidate& candidate : advice.candidates)
    json["candidates"].push_back(as_json(candidate));
  for (const auto& [key, sets] :
       {std::pair("refused", &advice.refused), {"surpassed", &advice.surpassed}})
    for (const auto& [c, point] : *sets) {
      json[key].push_back(as_json(advice.candidates[c], point));
      json[key].back()["scheme"] = advice.candidates[c].name;
    }
  const auto chosen = [&](std::size_t c) {
    nlohmann::json one = as_json(advice.candidates[c]);
    one.erase("points");
    return one;
  };
  if (advice.best) {
    json["best"] = chosen(*advice.best);
    json["best"]["confirmation"] = as_json(advice.candidates[*advice.best], advice.confirmation);
    json["best"]["reached_over_asked"] = advice.confirmation.bound / criterion.bound;
  } else {
    json["obstacle"] = unreachable(advice, criterion);
  }
  if (advice.runner_up) json["runner_up"] = chosen(*advice.runner_up);
  add_limits(json, equipartition(curves(advice)));
  return json.dump(2);
}

void print_advice(const Advice& advice, const Criterion& criterion, int threads) {
  fmt::print("{:<18} {:>8} {:>12} {:>10}   R % at the steps tried\n", "scheme", "step fs",
             "forces 1/ps", "ns/day");
  for (const Candidate& candidate : advice.candidates) {
    std::string tried;
    for (const AdviserPoint& p : candidate.points)
      tried += p.usable ? fmt::format(" {:.3g} fs: {:.3g}", p.step * units::fs_per_ps,
                                      100 * p.ratio().value)
                        : fmt::format(" {:.3g} fs: {}", p.step * units::fs_per_ps,
                                      blew_up(p.runs) ? "blew up" : "drifts");
    fmt::print(
        "{:<18} {:>8} {:>12} {:>10}  {}\n", candidate.name,
        candidate.step > 0 ? fmt::format("{:.3g}", candidate.step * units::fs_per_ps) : "-",
        candidate.step > 0 ? fmt::format("{:.0f}", candidate.scheme.cost() / candidate.step) : "-",
        candidate.seconds > 0 ? fmt::format("{:.3g}", candidate.ns_per_day()) : "-", tried);
  }
  for (const Candidate& candidate : advice.candidates)
    if (!candidate.obstacle.empty()) fmt::print("{}: {}\n", candidate.name, candidate.obstacle);
  for (const auto& [c, point] : advice.refused)
    fmt::print("not confirmed: {} at {:.3g} fs, {}\n", advice.candidates[c].name,
               point.step * units::fs_per_ps,
               blew_up(point.runs) ? "a run blew up"
                                   : fmt::format("R = {}, bound {}", percent(point.ratio()),
                                                 bound_text(criterion.quality, point.bound)));
  for (const auto& [c, point] : advice.surpassed)
    fmt::print("longer steps were tried: with {} at {:.3g} fs the bound is {}\n",
               advice.candidates[c].name, point.step * units::fs_per_ps,
               bound_text(criterion.quality, point.bound));
  if (!advice.best) return;
  const Candidate& best = advice.candidates[*advice.best];
  const AdviserPoint& p = advice.confirmation;
  fmt::print("\nfor {} use {} at {:.3g} fs\n", description(criterion), best.name,
             p.step * units::fs_per_ps);
  fmt::print("  R                   {}, mean of {} independent runs of {:.3g} ps\n",
             percent(p.ratio()), p.runs.size(), p.length);
  fmt::print("  {}{}\n",
             criterion.quality == Quality::ratio   ? "a fresh run         has R below "
             : criterion.quality == Quality::drift ? "drift               is smaller than "
                                                   : "temperature bias    is smaller than ",
             fmt::format("{} with a probability of {:g} %, {:.2g} of what was requested",
                         bound_text(criterion.quality, p.bound), 100 * guarantee_probability,
                         p.bound / criterion.bound));
  fmt::print("  drift per molecule  {:.3g} ± {:.2g} kJ/mol/ns\n", in_kJ_per_ns(p.drift().value),
             in_kJ_per_ns(p.drift().error));
  fmt::print("  temperature         {:.2f} K",
             mean(each(p.runs, [](const Outcome& run) { return run.temperatures.all; })).value);
  const char* before = "; off by";
  for (std::size_t k = 0; k < 4; ++k)
    if (bias(p, k).error > 0) {
      fmt::print("{} {} {}", before, kinds[k], percent(bias(p, k)));
      before = ",";
    }
  fmt::print("\n  speed               {:.3g} ns/day with {} {}\n", best.ns_per_day(), threads,
             threads == 1 ? "thread" : "threads");
  if (advice.runner_up) {
    const Candidate& second = advice.candidates[*advice.runner_up];
    fmt::print("  runner-up           {} at {:.3g} fs, {:.3g} ns/day, not confirmed\n", second.name,
               second.step * units::fs_per_ps, second.ns_per_day());
  }
  std::vector<Curve> shown = {curves(advice)[*advice.best]};
  if (advice.runner_up) shown.push_back(curves(advice)[*advice.runner_up]);
  print_temperatures(shown, equipartition(shown));
}

}  // namespace polhode::cli
