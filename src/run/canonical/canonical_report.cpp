// SPDX-License-Identifier: MIT
#include "polhode/run/canonical/canonical_report.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "polhode/base/error.hpp"
#include "polhode/io/ensemble_text.hpp"
#include "polhode/io/output_units.hpp"
#include "polhode/io/plot.hpp"
#include "polhode/run/canonical/canonical_record.hpp"
#include "polhode/run/simulation/system_notes.hpp"

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
                             in_words(p.accuracy()),
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
                      {"accuracy", in_words(p.accuracy())},
                      {"correlation_time_ps", as_json(p.correlation_time)},
                      {"force_evaluations_per_sample", as_json(p.evaluations_per_sample())}};
  if (p.method.hybrid)
    json["acceptance"] = as_json(p.acceptance), json["exp_dH"] = as_json(p.weight);
  for (std::size_t k = 0; k < canonical_quantities.size(); ++k) {
    nlohmann::json& one = json["quantities"][canonical_quantities[k].name];
    one = {{"mean", nullptr}, {"bias", nullptr}, {"accuracy", nullptr}};
    if (p.mean[k]) one["mean"] = as_json(*p.mean[k]);
    if (p.bias[k]) one["bias"] = as_json(*p.bias[k]);
    if (const auto accuracy = p.accuracy(k)) one["accuracy"] = in_words(*accuracy);
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
         q.bound});
  }
  figure.panels.push_back({"force evaluations per independent U", 0});
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
      "Shaded: the bounds. Hybrid Monte Carlo (hmc) is exact, and the reference. {} runs of {:g} "
      "ps "
      "per point, standard errors.",
      report.config.study.runs, report.config.study.length);
  return figure;
}

void write_study(const StudyFiles& files, const CanonicalReport& report,
                 const Provenance& provenance, const Callbacks& callbacks) {
  write_file(files.points,
             [&](std::ostream& out) { write_csv(out, point_table(report), provenance); });
  write_file(files.json, [&](std::ostream& out) { out << canonical_json(report) << '\n'; });
  pass_messages(callbacks, [&](std::ostream& warnings) {
    for (const char* format : {"svg", "png"})
      canonical_plot(files.prefix, figure(report), format, warnings);
  });
}

/// @throws Error  unless the settings describe a canonical study
void check_settings(const Config& config, const std::vector<CanonicalMethod>& methods) {
  if (config.ensemble.barostat)
    throw Error("a canonical study has a constant volume; leave the table [barostat] out",
                config.source);
  for (const CanonicalMethod& method : methods)
    if (config.study.length < 100 * method.step)
      throw Error(
          fmt::format("the study's length of {:g} fs is less than a hundred steps of {:g} fs, too "
                      "few for averages; use longer runs, or leave out long steps",
                      config.study.length * units::fs_per_ps, method.step * units::fs_per_ps),
          config.source);
}

/// The report of the runs that count, in its files.
CanonicalReport report_of(const Config& config, const std::vector<CanonicalRun>& runs,
                          const StudyFiles& files, const Provenance& provenance,
                          const Callbacks& callbacks) {
  std::vector<CanonicalRun> counted;
  for (const CanonicalRun& run : runs)
    if (run.start < config.study.runs) counted.push_back(run);
  CanonicalReport report(config, canonical_points(canonical_methods(config.study), counted,
                                                  config.system.temperature));
  // A study without a complete run has nothing to tabulate; what an earlier one wrote stays.
  if (!report.points.empty()) write_study(files, report, provenance, callbacks);
  return report;
}

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

std::string canonical_json(const CanonicalReport& report) {
  nlohmann::json json;
  json["conditions"] = canonical_conditions(report.config);
  for (const CanonicalQuantity& quantity : canonical_quantities)
    json["bounds"][quantity.name] = {{"value", quantity.bound}, {"unit", quantity.unit}};
  json["points"] = nlohmann::json::array();
  for (const CanonicalPoint& point : report.points) json["points"].push_back(as_json(point));
  json["claims"] = canonical_sentences(report);
  return json.dump(2);
}

CanonicalReport run_canonical_study(const Config& config, const std::string& prefix,
                                    const OutputOptions& options, const Callbacks& callbacks,
                                    Workers& workers) {
  check_prefix(prefix);
  const std::vector<CanonicalMethod> methods = canonical_methods(config.study);
  check_settings(config, methods);
  const System system = build_system(config);
  const StudyFiles files(prefix);
  const OutputLock lock(files.prefix + "-study.lock", callbacks);
  // Results of a resumed study are overwritten; those of another one are not.
  if (!std::filesystem::exists(files.runs)) check_outputs(files.all(), options.existing);
  const Provenance made =
      provenance(options.command, canonical_identity(config, system), config.system.seed);
  CanonicalRecord record(files.runs, made, options.existing == ExistingFiles::replace);
  std::vector<CanonicalRun> runs = record.known();
  callbacks.note(fmt::format(
      "polhode {}: canonical study of {} molecules, {} points of {} runs of {:g} ps, instruction "
      "set {}, threads {}",
      made.version, system.topology.size(), methods.size(), config.study.runs, config.study.length,
      made.instruction_set, workers.threads()));
  note_molecules(system, callbacks);
  note_forces(system, callbacks);
  if (!runs.empty())
    callbacks.note(fmt::format("{} runs are read from {}", runs.size(), files.runs));

  const auto keep = [&](const CanonicalRun& run) {
    record.add(run);
    runs.push_back(run);
  };
  perform_canonical_runs(config, record.known(), keep, callbacks, workers);
  CanonicalReport report = report_of(config, runs, files, made, callbacks);
  report.files = report.points.empty() ? std::vector{files.runs} : files.all();
  report.interrupted = callbacks.stopped();
  return report;
}

CanonicalReport report_canonical_record(const Config& config, const std::string& record,
                                        const std::string& prefix, const OutputOptions& options,
                                        const Callbacks& callbacks) {
  check_prefix(prefix);
  std::ifstream in(record, std::ios::binary);
  if (!in) throw Error(fmt::format("there is no record of a study '{}'; check its name", record));
  const std::vector<CanonicalRun> runs = read_canonical_record(in, record);
  const StudyFiles files(prefix);
  check_outputs(files.tables(), options.existing);
  const Provenance made = provenance(
      options.command, canonical_identity(config, build_system(config)), config.system.seed);
  CanonicalReport report = report_of(config, runs, files, made, callbacks);
  if (!report.points.empty()) report.files = files.tables();
  callbacks.note(fmt::format("{} runs are read from {}", runs.size(), record));
  return report;
}

}  // namespace polhode
