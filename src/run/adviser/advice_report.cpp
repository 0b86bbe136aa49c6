// SPDX-License-Identifier: MIT
#include "run/adviser/advice_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/settings/output_units.hpp"
#include "io/settings/quantity.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/io/figures/plot.hpp"
#include "run/adviser/advice_curves.hpp"
#include "run/simulation/system/system_notes.hpp"
#include "run/study/temperature_differences.hpp"

namespace polhode {
namespace {

constexpr const char* kinds[] = {"translation", "rotation_1", "rotation_2", "rotation_3"};

double in_kJ_per_ns(double power) { return power / unit("kJ/mol/ns", Dimension::power); }

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
    const Estimate bias = point.bias(k);
    if (bias.error == 0) continue;
    json["temperature_bias"][kinds[k]] = {{"value", bias.value}, {"error", bias.error}};
  }
  add_excesses(json, efficiency_point(candidate, point));
  json["R_rounding"] = point.max_rounding();
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

nlohmann::json as_json(const AdviceReport& report) {
  const Advice& advice = report.advice;
  const Criterion& criterion = report.criterion;
  nlohmann::json json{{"quality", name_of(criterion.quality)},
                      {"requested", criterion.bound},
                      {"probability", guarantee_probability},
                      {"interrupted", advice.stopped},
                      {"candidates", nlohmann::json::array()},
                      {"refused", nlohmann::json::array()},
                      {"surpassed", nlohmann::json::array()},
                      {"best", nullptr},
                      {"runner_up", nullptr}};
  if (criterion.quality == Quality::drift)
    json["requested"] = in_kJ_per_ns(criterion.bound), json["unit"] = "kJ/mol/ns per molecule";
  if (criterion.quality == Quality::temperature_difference) json["unit"] = "K";
  if (criterion.quality == Quality::energy_bias) json["unit"] = "kJ/mol per molecule";
  if (criterion.quality == Quality::pressure_bias) json["unit"] = "kJ/mol/nm3";
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
  return json;
}

void write_advice(const AdviceReport& report, const Provenance& provenance,
                  const Callbacks& callbacks) {
  const Advice& advice = report.advice;
  const Criterion& criterion = report.criterion;
  const AdviceFiles& files = report.files;
  write_file(files.points,
             [&](std::ostream& out) { write_csv(out, point_table(advice), provenance); });
  write_file(files.json, [&](std::ostream& out) { out << as_json(report).dump(2) << '\n'; });
  if (files.figure.empty()) return;
  AdviceFigure figure{figure_curves(advice), {}, {}};
  if (criterion.quality == Quality::ratio) figure.bound = criterion.bound;
  if (advice.best) {
    const Candidate& best = advice.candidates[*advice.best];
    figure.confirmed = {best.seconds, advice.confirmation.ratio().value,
                        advice.confirmation.ratio().error};
  }
  pass_messages(callbacks, [&](std::ostream& warnings) {
    advice_plot(files.prefix, figure, files.figure.substr(files.prefix.size() + 1), warnings);
  });
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

AdviceReport run_adviser(const Config& config, const AdviserSettings& settings,
                         const std::string& prefix, const OutputOptions& options,
                         const Callbacks& callbacks, Workers& workers) {
  check_prefix(prefix);
  AdviceReport report{{}, settings.criterion, workers.threads(), {prefix, config.output.plot}};
  check_outputs(report.files.all(), options.existing);
  const Provenance made = provenance(options.command, config.text, config.system.seed);
  const System system = build_system(config);
  callbacks.note(fmt::format(
      "polhode {}: advice for {} molecules, {}, about {:g} s, instruction set {}, threads {}",
      made.version, system.topology.size(), config.source, settings.seconds, made.instruction_set,
      workers.threads()));
  note_constant_energy(config, "the advice", callbacks);
  note_forces(system, callbacks);
  report.advice = advise(config, settings, callbacks, workers);
  if (!report.advice.stopped) write_advice(report, made, callbacks);
  return report;
}

std::string advice_json(const AdviceReport& report) {
  nlohmann::json json = as_json(report);
  json["threads"] = report.threads;
  return json.dump(2);
}

}  // namespace polhode
