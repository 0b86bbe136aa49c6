// SPDX-License-Identifier: MIT
#include "run/adviser/advice_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "io/figures/plot.hpp"
#include "io/files/with_error.hpp"
#include "io/files/write_file.hpp"
#include "io/settings/output_units.hpp"
#include "io/settings/quantity.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "run/output_files.hpp"
#include "run/quantity_lists.hpp"
#include "run/simulation/system/system_notes.hpp"
#include "run/study/equipartition.hpp"

namespace polhode {
namespace {

constexpr std::array<const char*, 4> kinds = {"translation", "rotation_1", "rotation_2",
                                              "rotation_3"};

double in_kJ_per_ns(double power) { return power / unit("kJ/mol/ns", Dimension::power); }

std::string percent(const Estimate& x) { return with_error(100 * x.value, 100 * x.error) + " %"; }

/// Results of the runs at a given step; the results are unknown if any run blew up.
Quantities of_point(const Candidate& candidate, const AdviserPoint& point) {
  const bool there = !blew_up(point.runs);
  const Estimate unknown{std::nan(""), std::nan("")};
  const Estimate R = there ? point.ratio() : unknown, drift = there ? point.drift() : unknown;
  Quantities list = {
      {"step", "fs", point.step * units::fs_per_ps, "time step"},
      {"length", "ps", point.length, "length of each run"},
      {"runs", "", point.runs.size(), "number of independent runs"},
      {"blew_up", "", !there, "whether any of the runs blew up", "", "", "-"},
      {"usable", "", point.usable, "whether no run blew up and no energy drift was found"},
      {"R", "", R,
       "rms fluctuation of the total energy, divided by the rms fluctuation of the potential "
       "energy; `R_error` is the standard error"},
      {"drift_per_molecule", "kJ/mol/ns", in_kJ_per_ns(drift.value), "energy drift per molecule"},
      {"drift_error", "[kJ/mol/ns]", in_kJ_per_ns(drift.error),
       "standard error of the energy drift"},
      {"bound", "", there ? point.bound : std::nan(""),
       "guaranteed upper bound on the required quantity in a new run"}};
  Quantities biases;
  for (std::size_t k = 0; there && k < kinds.size(); ++k)
    if (const Estimate bias = point.bias(k); bias.error != 0)
      biases.push_back({kinds[k], "", nested(bias)});
  if (!biases.empty())
    list.push_back({"temperature_bias", "", biases,
                    "temperatures of `translation`, `rotation_1`, ..., each as a relative "
                    "difference from the temperature of all degrees of freedom"});
  append(list, excesses(efficiency_point(candidate, point)));
  list.push_back({"R_rounding", "", there ? point.max_rounding() : std::nan(""),
                  "estimated round-off limit of R", "", "", "-"});
  return list;
}

/// A list of points as text, such as "4 fs: 0.5, 6 fs: blew up".
std::string tried_steps(const Candidate& candidate) {
  std::string text;
  for (const AdviserPoint& p : candidate.points)
    text += fmt::format("{}{:.3g} fs: {}", text.empty() ? "" : ", ", p.step * units::fs_per_ps,
                        p.usable          ? fmt::format("{:.3g}", 100 * p.ratio().value)
                        : blew_up(p.runs) ? "blew up"
                                          : "energy drifts");
  return text;
}

/// The results of a candidate, without its points.
Quantities of_candidate(const Candidate& candidate) {
  const bool has_step = candidate.step > 0, timed = candidate.seconds > 0;
  const double fs = candidate.step * units::fs_per_ps;
  const double cost = has_step ? candidate.scheme.cost() / candidate.step : 0;
  return {{"scheme", "", candidate.name, "name of the scheme, or its stages", "scheme"},
          {"text", "", text_of(candidate.scheme), "stages of the scheme as text"},
          {"step", "fs", fs,
           "time step that is expected to meet the required bound; 0 if no step does"},
          {"", "fs", has_step ? Value(fs) : Value(), "", "step"},
          {has_step ? "force_evaluations" : "", "1/ps", has_step ? Value(cost) : Value(),
           "force evaluations per ps at this time step", "forces"},
          {"ns_per_day", "", candidate.ns_per_day(), "speed at this time step; 0 if not measured"},
          {"", "", timed ? Value(candidate.ns_per_day()) : Value(), "", "ns/day"},
          {candidate.obstacle.empty() ? "" : "obstacle", "",
           candidate.obstacle.empty() ? Value() : Value(candidate.obstacle),
           "reason why no time step meets the required bound"}};
}

std::vector<Quantities> candidate_records(const Advice& advice) {
  std::vector<Quantities> records;
  for (const Candidate& candidate : advice.candidates) {
    records.push_back(of_candidate(candidate));
    std::vector<Quantities> points;
    for (const AdviserPoint& point : candidate.points) points.push_back(of_point(candidate, point));
    append(records.back(), {{"points", "", points, "exploratory runs at each step"},
                            row("R [%] at each time step tried", tried_steps(candidate))});
  }
  return records;
}

/// Confirming runs that did not confirm their scheme and step.
std::vector<Quantities> point_records(
    const Advice& advice, const std::vector<std::pair<std::size_t, AdviserPoint>>& sets) {
  std::vector<Quantities> records;
  for (const auto& [c, point] : sets) {
    records.push_back({{"scheme", "", advice.candidates[c].name, "name of the scheme"}});
    append(records.back(), of_point(advice.candidates[c], point));
  }
  return records;
}

/// All points. The last points of a curve are from confirming runs.
std::vector<Quantities> table_records(const Advice& advice) {
  std::vector<std::pair<std::size_t, AdviserPoint>> explored, confirmed = advice.refused;
  for (std::size_t c = 0; c < advice.candidates.size(); ++c)
    for (const AdviserPoint& point : advice.candidates[c].points) explored.emplace_back(c, point);
  confirmed.insert(confirmed.end(), advice.surpassed.begin(), advice.surpassed.end());
  if (advice.best) confirmed.emplace_back(*advice.best, advice.confirmation);
  std::vector<Quantities> records;
  for (const auto* set : {&explored, &confirmed})
    for (Quantities& record : point_records(advice, *set)) {
      record.push_back({"confirms", "", set == &confirmed});
      records.push_back(std::move(record));
    }
  return records;
}

/// The curve of a candidate that has a step and a measured time: its points and its model.
AdviceFigure::Curve curve_of(const Candidate& c, std::size_t first) {
  AdviceFigure::Curve curve{
      {c.name, first, first + c.points.size() - 1}, c.step * units::fs_per_ps, c.seconds};
  if (!c.model) return curve;
  curve.ratio = std::exp(c.model->log_ratio(c.step).value);
  curve.exponent = c.model->exponent(c.step);
  curve.short_exponent = c.model->exponent(0);
  return curve;
}

/// @param rows  number of rows in the table; the last row is the answer
AdviceFigure figure_of(const AdviceReport& report, std::size_t rows) {
  const Advice& advice = report.advice;
  AdviceFigure figure{report.files.points, {}};
  std::size_t row = 0;
  for (std::size_t c = 0; c < advice.candidates.size(); ++c) {
    const Candidate& candidate = advice.candidates[c];
    if (candidate.seconds > 0) {
      if (c == advice.best) figure.confirmed = {figure.curves.size(), rows - 1};
      figure.curves.push_back(curve_of(candidate, row));
    }
    row += candidate.points.size();
  }
  if (report.criterion.quality == Quality::ratio) figure.bound = report.criterion.bound;
  return figure;
}

/// One line for each candidate without a step and for each set of unsuccessful confirming runs,
/// with the reason.
Quantities obstacles(const AdviceReport& r) {
  const Advice& advice = r.advice;
  Quantities lines;
  for (const Candidate& candidate : advice.candidates)
    if (!candidate.obstacle.empty())
      lines.push_back(detail(row("", fmt::format("{}: {}", candidate.name, candidate.obstacle))));
  const auto at = [&](std::size_t c, const AdviserPoint& point) {
    return fmt::format("{} at {:.3g} fs", advice.candidates[c].name, point.step * units::fs_per_ps);
  };
  const auto bound = [&](const AdviserPoint& point) {
    return bound_text(r.criterion.quality, point.bound);
  };
  for (const auto& [c, point] : advice.refused)
    lines.push_back(detail(row(
        "", fmt::format("not confirmed: {}, {}", at(c, point),
                        blew_up(point.runs) ? "a run blew up"
                                            : fmt::format("R = {}, bound {}",
                                                          percent(point.ratio()), bound(point))))));
  for (const auto& [c, point] : advice.surpassed)
    lines.push_back(
        detail(row("", fmt::format("confirmed, but then a longer step was found: {}, bound {}",
                                   at(c, point), bound(point)))));
  return lines;
}

std::string temperature_text(const AdviserPoint& p) {
  std::string text = fmt::format(
      "{:.2f} K",
      mean(each(p.runs, [](const Outcome& run) { return run.temperatures.all; })).value);
  const char* before = "; off by";
  for (std::size_t k = 0; k < kinds.size(); ++k)
    if (p.bias(k).error > 0) {
      text += fmt::format("{} {} {}", before, kinds[k], percent(p.bias(k)));
      before = ",";
    }
  return text;
}

/// The answer.
Quantities of_best(const AdviceReport& r) {
  const Criterion& criterion = r.criterion;
  const Candidate& best = r.advice.candidates[*r.advice.best];
  const AdviserPoint& p = r.advice.confirmation;
  const bool of_R = criterion.quality == Quality::ratio;
  const std::string_view name = name_of(criterion.quality);
  const Estimate drift = p.drift();
  Quantities list = without_labels(of_candidate(best));
  append(
      list,
      {{"confirmation", "", of_point(best, p), "independent runs with the advised scheme and step"},
       {"reached_over_asked", "", p.bound / criterion.bound,
        "guaranteed bound, divided by the required bound"},
       row("R", fmt::format("{}, mean of {} independent runs of {:.3g} ps", percent(p.ratio()),
                            p.runs.size(), p.length)),
       row(of_R ? "a new run" : std::string(name.substr(0, name.find(" of "))),
           fmt::format(
               "{} {} with a probability of {:g} %; this bound is {:.2g} times the requested bound",
               of_R ? "has R below" : "is smaller than", bound_text(criterion.quality, p.bound),
               100 * guarantee_probability, p.bound / criterion.bound)),
       row("energy drift", with_error(in_kJ_per_ns(drift.value), in_kJ_per_ns(drift.error)) +
                               " kJ/mol/ns per molecule"),
       row("temperature", temperature_text(p)),
       row("speed", fmt::format("{:.3g} ns/day with {} {}", best.ns_per_day(), r.threads,
                                r.threads == 1 ? "thread" : "threads"))});
  return list;
}

/// The second-best candidate, and the configurational temperatures of the best two candidates.
Quantities of_others(const Advice& advice) {
  if (!advice.best) return {};
  const std::vector<Curve> all = curves(advice);
  std::vector<Curve> shown = {all[*advice.best]};
  Quantities list;
  if (advice.runner_up) {
    const Candidate& second = advice.candidates[*advice.runner_up];
    shown.push_back(all[*advice.runner_up]);
    list.push_back(
        row("  runner-up", fmt::format("{} at {:.3g} fs, {:.3g} ns/day, not confirmed", second.name,
                                       second.step * units::fs_per_ps, second.ns_per_day())));
  }
  for (const Quantity& table : temperature_tables(shown, equipartition(shown)))
    list.push_back(detail(table));
  return list;
}

Quantities of_criterion(const Criterion& criterion) {
  const bool drift = criterion.quality == Quality::drift;
  const char* unit = drift ? "kJ/mol/ns per molecule"
                     : criterion.quality == Quality::temperature_difference ? "K"
                     : criterion.quality == Quality::energy_bias            ? "kJ/mol per molecule"
                     : criterion.quality == Quality::pressure_bias          ? "kJ/mol/nm3"
                                                                            : "";
  return {
      {"quality", "", std::string(name_of(criterion.quality)), "quantity that is bounded"},
      {"requested", "", drift ? in_kJ_per_ns(criterion.bound) : criterion.bound, "required bound"},
      {*unit == 0 ? "" : "unit", "", *unit == 0 ? Value() : Value(unit), "unit of the bound"},
      {"probability", "", guarantee_probability, "probability that a new run meets the bound"}};
}

void write_advice(const AdviceReport& report, const Provenance& provenance,
                  const Callbacks& callbacks) {
  const AdviceFiles& files = report.files;
  const Table points = table_of(table_records(report.advice));
  write_file(files.points, [&](std::ostream& out) { write_csv(out, points, provenance); });
  write_file(files.json, [&](std::ostream& out) { out << json_text(quantities(report)) << '\n'; });
  if (files.figure.empty()) return;
  pass_messages(callbacks, [&](std::ostream& warnings) {
    draw_figure(figure_of(report, points.rows.size()), files.figure.substr(files.prefix.size() + 1),
                warnings);
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
  check_not_processed(config, "the adviser");
  note_constant_energy(config, "the advice", callbacks);
  note_forces(system, callbacks);
  report.advice = advise(config, settings, callbacks, workers);
  if (!report.advice.stopped) write_advice(report, made, callbacks);
  return report;
}

Quantities quantities(const AdviceReport& r) {
  const Advice& advice = r.advice;
  Quantities list = of_criterion(r.criterion);
  append(list, {{"interrupted", "", advice.stopped, "whether the search was suspended"},
                {"threads", "", r.threads, "number of simultaneous runs"},
                detail({"candidates", "", candidate_records(advice), "schemes that were compared",
                        "candidates"}),
                {"refused", "", point_records(advice, advice.refused),
                 "runs that did not confirm a proposed scheme and step"},
                {"surpassed", "", point_records(advice, advice.surpassed),
                 "runs that confirmed a scheme and step, before a better choice was found"}});
  append(list, obstacles(r));
  if (advice.best)
    list.push_back({"best", "", of_best(r), "advised scheme and step",
                    fmt::format("for {} use {} at {:.3g} fs", description(r.criterion),
                                advice.candidates[*advice.best].name,
                                advice.confirmation.step * units::fs_per_ps)});
  else
    append(list, {{"best", "", {}},
                  {"obstacle", "", unreachable(advice, r.criterion),
                   "reason why no scheme meets the requirement"}});
  append(list, of_others(advice));
  list.push_back({"runner_up", "", {}, "second-best scheme and step, not confirmed"});
  if (advice.runner_up)
    list.back().value = without_labels(of_candidate(advice.candidates[*advice.runner_up]));
  append(list, limits(equipartition(curves(advice))));
  if (!advice.stopped) list.push_back(row_of_files(r.files.all()));
  return list;
}

EfficiencyPoint efficiency_point(const Candidate& candidate, const AdviserPoint& point) {
  const StudyPoint studied{candidate.name, {candidate.scheme}, point.step};
  std::vector<StudyRun> runs;
  for (const Outcome& run : point.runs)
    runs.push_back({.scheme = studied.record_name(),
                    .step = point.step,
                    .start = static_cast<int>(runs.size()),
                    .stable = run.failure.empty(),
                    .ratio = run.ratio,
                    .drift = run.drift,
                    .temperature = run.temperatures.all,
                    .rounding = run.rounding,
                    .parts = run.temperatures,
                    .configurational = run.configurational});
  return efficiency_points({studied}, runs, point.length).front();
}

std::vector<Curve> curves(const Advice& advice) {
  std::vector<Curve> all;
  for (std::size_t c = 0; c < advice.candidates.size(); ++c) {
    const Candidate& candidate = advice.candidates[c];
    std::vector<AdviserPoint> points = candidate.points;
    for (const auto* sets : {&advice.refused, &advice.surpassed})
      for (const auto& [of, point] : *sets)
        if (of == c) points.push_back(point);
    if (advice.best == c) points.push_back(advice.confirmation);
    std::stable_sort(points.begin(), points.end(),
                     [](const auto& a, const auto& b) { return a.step < b.step; });
    Curve curve{candidate.name, {}, 0};
    bool usable = true;
    for (const AdviserPoint& point : points) {
      usable = usable && point.usable;
      if (usable) ++curve.usable;
      curve.points.push_back(efficiency_point(candidate, point));
    }
    all.push_back(curve);
  }
  return all;
}

std::string bound_text(Quality quality, double bound) {
  switch (quality) {
    case Quality::drift:
      return fmt::format("{:.3g} kJ/mol/ns", bound / unit("kJ/mol/ns", Dimension::power));
    case Quality::temperature_difference:
      return fmt::format("{:.3g} K", bound);
    case Quality::energy_bias:
      return fmt::format("{:.3g} kJ/mol", bound);
    case Quality::pressure_bias:
      return fmt::format("{:.3g} bar", bound / unit("bar", Dimension::pressure));
    case Quality::ratio:
    case Quality::temperature_bias:
      break;
  }
  return fmt::format("{:.3g} %", 100 * bound);
}

std::string description(const Criterion& criterion) {
  const std::string_view name = name_of(criterion.quality);
  const bool vowel = name[0] == 'e' || name[0] == 'R';
  return fmt::format("{} {} of at most {}", vowel ? "an" : "a", name,
                     bound_text(criterion.quality, criterion.bound));
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
           "; at every step tried, a run blew up or had an energy drift: equilibrate longer, or "
           "check the initial configuration";
  text += fmt::format("; the smallest bound reached is {}, with {} at {:.3g} fs",
                      bound_text(criterion.quality, reached->bound), best->name,
                      reached->step * units::fs_per_ps);
  if (reached->max_rounding() > 0.5 * reached->ratio().value)
    text += fmt::format(
        ". At this step the round-off limit of mixed precision is R = {:.2g} %; precision = "
        "\"double\" removes this limit",
        100 * reached->max_rounding());
  if (criterion.quality != Quality::ratio)
    text +=
        ". The bound includes the standard error of the mean; a longer search or longer runs "
        "reduce this error";
  return text;
}

std::string answer(const Advice& advice) {
  const AdviserPoint& p = advice.confirmation;
  const Estimate R = p.ratio();
  return fmt::format("{} at {:.3g} fs, R = {:.3g} ± {:.2g} % in {} independent runs of {:.3g} ps",
                     advice.candidates[*advice.best].name, p.step * units::fs_per_ps, 100 * R.value,
                     100 * R.error, p.runs.size(), p.length);
}

}  // namespace polhode
