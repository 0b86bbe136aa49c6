// SPDX-License-Identifier: MIT
#include "polhode/run/analysis/analysis_report.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "analysis_files.hpp"
#include "polhode/base/error.hpp"
#include "polhode/base/units.hpp"
#include "polhode/io/quantity.hpp"

namespace polhode {
namespace {

/// The files that may be written, depending on what the frames allow.
std::vector<std::string> possible_files(const AnalysisInput& input) {
  std::set<Observable> what = input.settings.what;
  if (what.empty())
    for (const std::string& name : observable_names()) what.insert(observable(name));
  std::vector<std::string> files;
  for (const std::string& name : file_names(what))
    for (const std::string& extension : {std::string("csv"), std::string("gp"), input.plot})
      if (extension == "csv" || input.plot != "none")
        files.push_back(fmt::format("{}-{}.{}", input.prefix, name, extension));
  return files;
}

std::optional<Frame> names_of_atoms(const std::string& file) {
  if (file.empty()) return std::nullopt;
  Frame names;
  if (!open_frames(file)->next(names))
    throw Error(fmt::format("'{}' contains no frame; give a file with at least one", file));
  return names;
}

/// Tables and figures of all curves.
std::vector<std::string> write_files(AnalysisReport& report, const AnalysisInput& input,
                                     const Provenance& made, const Callbacks& callbacks,
                                     Workers& workers) {
  std::vector<std::string> written;
  for (AnalysisFile& file : analysis_files(report.analysis, report.summary, workers)) {
    const std::string csv = fmt::format("{}-{}.csv", input.prefix, file.name);
    write_file(csv, [&](std::ostream& out) { write_csv(out, file.table, made); });
    written.push_back(csv);
    if (input.plot == "none" || file.figure.panels.empty()) continue;
    file.figure.csv = csv;
    pass_messages(callbacks, [&](std::ostream& warnings) {
      if (curves_plot(file.figure, input.plot, warnings))
        written.push_back(fmt::format("{}-{}.{}", input.prefix, file.name, input.plot));
    });
  }
  return written;
}

/// The standard error; NaN if it is not known, which is null in JSON.
double known_error(const SeriesEstimate& e) {
  return e.known == Known::yes ? e.error : std::nan("");
}

nlohmann::json pair(const SeriesEstimate& e, double scale = 1) {
  return {{"value", e.value * scale}, {"error", known_error(e) * scale}};
}

/// The same if it is converged. If not, it has no value: what the run gives is an estimate, with
/// the reason.
nlohmann::json converging(const SeriesEstimate& e, const Convergence& c,
                          const RelaxationName& relaxation, double scale = 1) {
  nlohmann::json one = pair(e, scale);
  one["converged"] = c.converged();
  if (c.converged()) return one;
  const auto key = [&](const char* what) { return fmt::format("{}_{}", what, c.unit); };
  one.update({{"value", nullptr},
              {"error", nullptr},
              {"unconverged_estimate", e.value * scale},
              {"reason", not_converged(c, relaxation)},
              {key("length"), c.length},
              {key("relaxation"), c.relaxation},
              {key("needed"), c.needed}});
  if (c.obstacle == Obstacle::interval) one["needed_interval_ps"] = c.interval;
  return one;
}

nlohmann::json relaxation_json(const std::optional<RelaxationTimes>& t) {
  if (!t) return {{"converged", false}, {"reason", not_decayed}};
  return {{"integral_ps", converging(t->integral, t->convergence, decay_time)},
          {"exponential_ps", converging(t->exponential, t->convergence, decay_time)},
          {"fit_ps", {t->from, t->to}}};
}

/// Null for numbers that do not exist without a peak.
nlohmann::json peak_json(const SitePair& sites,
                         const std::optional<RadialDistribution::Peak>& peak) {
  if (!peak)
    return {{"pair", sites},           {"peak_nm", nullptr},
            {"peak_height", nullptr},  {"minimum_nm", nullptr},
            {"coordination", nullptr}, {"coordination_of_second", nullptr}};
  return {
      {"pair", sites},
      {"peak_nm", pair(peak->position)},
      {"peak_height", pair(peak->height)},
      {"minimum_nm", peak->shell ? nlohmann::json(peak->shell->end.value) : nlohmann::json()},
      {"coordination", peak->shell ? pair(peak->shell->coordination) : nlohmann::json()},
      {"coordination_of_second", peak->shell ? pair(peak->shell->of_second) : nlohmann::json()}};
}

/// What the step changes in the numbers of a peak.
nlohmann::json peak_bias_json(const RadialDistribution::Peak& bias) {
  return {{"peak_nm", pair(bias.position)},
          {"peak_height", pair(bias.height)},
          {"coordination", bias.shell ? pair(bias.shell->coordination) : nlohmann::json()}};
}

nlohmann::json part_json(const PartSummary& part, const AnalysisSummary& s) {
  nlohmann::json one = {{"molecule", part.molecule}, {"count", part.count}};
  if (part.diffusion)
    one["D_1e-9_m2_per_s"] =
        converging(*part.diffusion, part.diffusion_convergence, max_lag, in_1e9_m2_per_s);
  if (const auto D = part.corrected(s))
    one["D_without_images_1e-9_m2_per_s"] =
        converging(*D, part.diffusion_convergence, max_lag, in_1e9_m2_per_s);
  if (part.green_kubo)
    one["D_green_kubo_1e-9_m2_per_s"] =
        converging(*part.green_kubo, part.green_kubo_convergence, max_lag, in_1e9_m2_per_s);
  for (const AxisRelaxation& axis : part.axes)
    for (std::size_t k = 0; k < 2; ++k)
      one["relaxation"][axis.axis][fmt::format("P{}", k + 1)] = relaxation_json(axis.rank[k]);
  return one;
}

/// Why no observable could be computed.
std::string why_nothing(const AnalysisSummary& s) {
  return fmt::format("nothing was computed: {}", s.notes.empty()
                                                     ? "no observable was requested"
                                                     : fmt::format("{}", fmt::join(s.notes, "; ")));
}

}  // namespace

AnalysisReport run_analysis(const AnalysisInput& input, const OutputOptions& options,
                            const Callbacks& callbacks, Workers& workers) {
  check_prefix(input.prefix);
  const std::optional<Frame> names = names_of_atoms(input.names);
  const auto reader = open_frames(input.trajectory, names ? &*names : nullptr);
  check_outputs(possible_files(input), options.existing);
  AnalysisReport report;
  report.analysis = analyze(*reader, input.topology, input.settings, callbacks, workers);
  if (report.analysis.stopped)
    callbacks.note(
        fmt::format("interrupted after {} frames; their results follow", report.analysis.frames));
  report.summary = summary(report.analysis, input.summary, workers);
  if (report.analysis.deviation > 1e-4)
    callbacks.note(fmt::format("note: atoms deviate by up to {:.4f} nm from the rigid models",
                               report.analysis.deviation));
  const Provenance made = provenance(options.command, input.origin, input.seed);
  report.files = write_files(report, input, made, callbacks, workers);
  if (report.files.empty() && !report.analysis.stopped) throw Error(why_nothing(report.summary));
  for (const std::string& note : report.summary.notes) callbacks.note("note: " + note);
  return report;
}

std::string analysis_json(const AnalysisReport& report) {
  const Analysis& a = report.analysis;
  const AnalysisSummary& s = report.summary;
  nlohmann::json json = {
      {"frames", a.frames},
      {"first_ps", a.first},
      {"last_ps", a.last},
      {"interval_ps", a.interval},
      {"molecules", a.topology.size()},
      {"fit_deviation_nm", a.deviation},
      {"interrupted", a.stopped},
      {"notes", s.notes},
      {"density_g_per_cm3", pair(a.conditions->density(), 1 / units::gram_per_cm3)},
      {"density_kg_per_m3", pair(a.conditions->density(), 1 / unit("kg/m3", Dimension::density))},
      {"temperature_source", s.temperature_source}};
  if (a.has_velocities) json["temperature_K"] = pair(a.conditions->temperature());
  for (std::size_t k = 0; k < s.peaks.size(); ++k) {
    json["rdf"].push_back(peak_json(a.pairs[k], s.peaks[k]));
    if (a.fixed && s.peaks_bias[k])
      json["rdf"].back()["step_bias"] = peak_bias_json(*s.peaks_bias[k]);
  }
  if (a.displacement)
    json["diffusion"] = {{"fit_ps", {s.fit.from, s.fit.to}},
                         {"viscosity_source", s.viscosity_source}};
  if (s.finite_size_correction)
    json["diffusion"]["finite_size_correction_1e-9_m2_per_s"] =
        in_1e9_m2_per_s * *s.finite_size_correction;
  for (const PartSummary& part : s.parts) json["parts"].push_back(part_json(part, s));
  if (const auto& d = s.dielectric)
    json["dielectric"] = {{"constant", converging(d->constant, d->convergence, dipole_relaxation)},
                          {"kirkwood", converging(d->kirkwood, d->convergence, dipole_relaxation)},
                          {"mean_over_rms_dipole", d->mean_over_rms}};
  if (const auto& bias = s.dielectric_bias)
    json["dielectric"]["step_bias"] = {{"constant", pair(bias->constant)},
                                       {"kirkwood", pair(bias->kirkwood)}};
  if (a.fixed) json["frames_with_step_error"] = a.frames_with_step_error;
  json["files"] = report.files;
  return json.dump(2);
}

}  // namespace polhode
