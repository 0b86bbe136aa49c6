// SPDX-License-Identifier: MIT
#include "run/canonical/canonical_report.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/settings/ensemble_text.hpp"
#include "io/settings/output_units.hpp"
#include "polhode/base/error.hpp"
#include "polhode/io/figures/plot.hpp"
#include "run/canonical/canonical_record.hpp"
#include "run/study/study_job.hpp"

namespace polhode {
namespace {

Table point_table(const CanonicalReport& report) {
  Table table;
  table.columns = {{"scheme", ""},
                   {"step", "fs"},
                   {"cost", "1/ps"},
                   {"runs", "1"},
                   {"stable", "1"},
                   {"accuracy", ""},
                   {"loose_accuracy", ""},
                   {"correlation_time", "ps"},
                   {"correlation_time_error", "ps"},
                   {"evaluations_per_sample", "1"},
                   {"evaluations_per_sample_error", "1"},
                   {"acceptance", "1"},
                   {"exp_dH", "1"},
                   {"exp_dH_error", "1"}};
  for (const CanonicalQuantity& quantity : canonical_quantities)
    for (const char* kind : {"", "_error", "_bias", "_bias_error"})
      table.columns.push_back({std::string(quantity.name) + kind, quantity.unit});
  for (const CanonicalPoint& p : report.points) {
    const Estimate sample = p.evaluations_per_sample();
    std::vector<Cell> row = {p.method.name,
                             p.method.step * units::fs_per_ps,
                             p.method.cost(),
                             static_cast<double>(p.runs),
                             p.stable ? 1.0 : 0.0,
                             in_words(p.accuracy(BiasCriterion::strict)),
                             in_words(p.accuracy(BiasCriterion::loose)),
                             p.correlation_time.value,
                             p.correlation_time.error,
                             sample.value,
                             sample.error,
                             p.acceptance.value,
                             p.weight.value,
                             p.weight.error};
    for (std::size_t k = 0; k < canonical_quantities.size(); ++k)
      for (const auto& estimate : {p.mean[k], p.bias[k]}) {
        const Estimate known = estimate.value_or(Estimate{std::nan(""), std::nan("")});
        row.insert(row.end(), {known.value, known.error});
      }
    table.rows.push_back(std::move(row));
  }
  return table;
}

nlohmann::json finite(double value) {
  return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json();
}

nlohmann::json as_json(const Estimate& e) {
  return {{"value", finite(e.value)}, {"error", finite(e.error)}};
}

nlohmann::json as_json(const CanonicalPoint& p) {
  nlohmann::json json{{"scheme", p.method.name},
                      {"step_fs", p.method.step * units::fs_per_ps},
                      {"force_evaluations_per_ps", p.method.cost()},
                      {"hybrid_monte_carlo", p.method.hybrid},
                      {"runs", p.runs},
                      {"stable", p.stable},
                      {"accuracy", in_words(p.accuracy(BiasCriterion::strict))},
                      {"loose_accuracy", in_words(p.accuracy(BiasCriterion::loose))},
                      {"correlation_time_ps", as_json(p.correlation_time)},
                      {"force_evaluations_per_sample", as_json(p.evaluations_per_sample())}};
  if (p.method.hybrid)
    json["acceptance"] = as_json(p.acceptance), json["exp_dH"] = as_json(p.weight);
  for (std::size_t k = 0; k < canonical_quantities.size(); ++k) {
    nlohmann::json& one = json["quantities"][canonical_quantities[k].name];
    one = {
        {"mean", nullptr}, {"bias", nullptr}, {"accuracy", nullptr}, {"loose_accuracy", nullptr}};
    if (p.mean[k]) one["mean"] = as_json(*p.mean[k]);
    if (p.bias[k]) one["bias"] = as_json(*p.bias[k]);
    if (!p.bias[k]) continue;
    one["accuracy"] = in_words(*p.accuracy(k, BiasCriterion::strict));
    one["loose_accuracy"] = in_words(*p.accuracy(k, BiasCriterion::loose));
  }
  return json;
}

/// The quantities of the figure, in panels: the cost of a sample is the last one.
constexpr std::array<std::size_t, 5> drawn = {0, 1, 2, 5, 4};

CanonicalFigure figure(const CanonicalReport& report) {
  CanonicalFigure figure;
  for (const std::size_t k : drawn) {
    const CanonicalQuantity& q = canonical_quantities[k];
    const bool unitless = std::string_view(q.unit) == "1";
    figure.panels.push_back(
        {fmt::format("bias of {}{}", q.label, unitless ? "" : fmt::format("  ({})", q.unit)),
         q.strict, q.loose});
  }
  figure.panels.push_back({"force evaluations per independent U"});
  for (const CanonicalPoint& p : report.points) {
    if (!p.stable) continue;
    if (figure.curves.empty() || figure.curves.back().scheme != p.method.name)
      figure.curves.push_back({p.method.name, {}});
    CanonicalMark mark{p.method.cost(), {}};
    for (const std::size_t k : drawn) {
      const Estimate bias = p.bias[k].value_or(Estimate{std::nan(""), std::nan("")});
      mark.values.emplace_back(bias.value, bias.error);
    }
    const Estimate sample = p.evaluations_per_sample();
    mark.values.emplace_back(sample.value, sample.error);
    figure.curves.back().marks.push_back(mark);
  }
  figure.caption = fmt::format(
      "Shaded: the strict and the loose bounds. Points of one cost are drawn side by side. Hybrid "
      "Monte Carlo (hmc) is exact, and the reference. {} runs of {:g} ps "
      "per point, standard errors.",
      report.config.study.runs, report.config.study.length);
  return figure;
}

/// The study of canonical averages.
struct CanonicalStudy {
  using Run = CanonicalRun;
  using Record = CanonicalRecord;
  using Report = CanonicalReport;

  static constexpr const char* title = "canonical study";
  static constexpr auto identity = canonical_identity;
  static constexpr auto perform = perform_canonical_runs;
  static constexpr auto table_of = point_table;
  static constexpr auto figure_of = figure;
  static constexpr auto plot = canonical_plot;

  const Config& config;
  std::vector<CanonicalMethod> methods = canonical_methods(config.study);

  std::size_t points() const { return methods.size(); }

  void check(const System&) const {
    if (config.ensemble.barostat)
      throw Error("a canonical study has a constant volume; leave the table [barostat] out",
                  config.source);
    for (const CanonicalMethod& method : methods)
      if (config.study.length < 100 * method.step)
        throw Error(
            fmt::format(
                "the study's length of {:g} fs is less than a hundred steps of {:g} fs, too few "
                "for averages; use longer runs, or leave out long steps",
                config.study.length * units::fs_per_ps, method.step * units::fs_per_ps),
            config.source);
  }

  void note(const Callbacks&) const {}

  CanonicalReport report(const System&, const std::vector<CanonicalRun>& runs) const {
    return {config, canonical_points(methods, runs, config.system.temperature)};
  }
};

}  // namespace

std::string canonical_conditions(const Config& config) {
  EnsembleSettings bath;
  bath.temperature = config.system.temperature;
  bath.thermostat = config.ensemble.thermostat.value_or(ThermostatSettings{});
  const auto hybrid = config.ensemble.hybrid_monte_carlo.value_or(HybridMonteCarloSettings{});
  return fmt::format(
      "at most {} runs of {:g} ps, the first {:g} ps of which are not counted, from canonical "
      "configurations, the same for every scheme; schemes with a bath: {}; hybrid Monte Carlo: {} "
      "steps per trajectory; temperatures are compared with {:g} K, other averages with those of "
      "hybrid Monte Carlo",
      config.study.runs, config.study.length, relaxation(config.study.length), description(bath),
      hybrid.steps, config.system.temperature);
}

std::string study_json(const CanonicalReport& report) {
  nlohmann::json json;
  json["conditions"] = canonical_conditions(report.config);
  for (const CanonicalQuantity& quantity : canonical_quantities)
    json["bounds"][quantity.name] = {
        {"value", quantity.strict}, {"loose", quantity.loose}, {"unit", quantity.unit}};
  json["points"] = nlohmann::json::array();
  for (const CanonicalPoint& point : report.points) json["points"].push_back(as_json(point));
  json["claims"] = canonical_sentences(report.findings[0], report.points);
  json["loose_claims"] = canonical_sentences(report.findings[1], report.points);
  return json.dump(2);
}

CanonicalReport run_canonical_study(const Config& config, const std::string& prefix,
                                    const OutputOptions& options, const Callbacks& callbacks,
                                    Workers& workers) {
  const CanonicalStudy study{config};
  return StudyJob(study, prefix, options, callbacks).run(workers);
}

CanonicalReport report_canonical_record(const Config& config, const std::string& record,
                                        const std::string& prefix, const OutputOptions& options,
                                        const Callbacks& callbacks) {
  const CanonicalStudy study{config};
  return StudyJob(study, prefix, options, callbacks).from(record);
}

}  // namespace polhode
