// SPDX-License-Identifier: MIT
#include "run/analysis/analysis_report.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <optional>

#include "io/figures/plot.hpp"
#include "io/files/write_file.hpp"
#include "io/settings/quantity.hpp"
#include "polhode/base/error.hpp"
#include "polhode/base/units.hpp"
#include "run/output_files.hpp"
#include "run/quantity_lists.hpp"

namespace polhode {
namespace {

/// The files that may be written; the frames determine which are written.
std::vector<std::string> possible_files(const AnalysisInput& input) {
  const std::set<std::string>& what = input.settings.what;
  std::vector<std::string> files;
  for (const ObservableKind& kind : observables())
    for (const std::string& name : kind.files)
      for (const std::string& extension : {std::string("csv"), std::string("gp"), input.plot})
        if ((what.empty() || what.contains(kind.name)) &&
            (extension == "csv" || input.plot != "none"))
          files.push_back(fmt::format("{}-{}.{}", input.prefix, name, extension));
  return files;
}

std::optional<Frame> names_of_atoms(const std::string& file) {
  if (file.empty()) return std::nullopt;
  Frame names;
  if (!open_frames(file)->next(names))
    throw Error(fmt::format("'{}' contains no frame; give a file with at least one frame", file));
  return names;
}

/// Writes the tables and figures of all curves.
std::vector<std::string> write_files(AnalysisReport& report, const AnalysisInput& input,
                                     const Provenance& made, const Callbacks& callbacks) {
  std::vector<std::string> written;
  for (AnalysisFile& file : report.summary.files) {
    const std::string csv = fmt::format("{}-{}.csv", input.prefix, file.name);
    write_file(csv, [&](std::ostream& out) { write_csv(out, file.table, made); });
    written.push_back(csv);
    if (input.plot == "none" || file.figure.panels.empty()) continue;
    file.figure.csv = csv;
    pass_messages(callbacks, [&](std::ostream& warnings) {
      if (draw_figure(file.figure, input.plot, warnings))
        written.push_back(fmt::format("{}-{}.{}", input.prefix, file.name, input.plot));
    });
  }
  return written;
}

/// The reason why no observable could be computed.
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
    callbacks.note(fmt::format("interrupted after {} frames; the results from these frames follow",
                               report.analysis.frames));
  report.summary = summary(report.analysis, input.summary, workers);
  if (report.analysis.deviation > 1e-4)
    callbacks.note(fmt::format("note: atoms deviate by up to {:.4f} nm from the rigid models",
                               report.analysis.deviation));
  const Provenance made = provenance(options.command, input.origin, input.seed);
  report.files = write_files(report, input, made, callbacks);
  if (report.files.empty() && !report.analysis.stopped) throw Error(why_nothing(report.summary));
  for (const std::string& note : report.summary.notes) callbacks.note("note: " + note);
  return report;
}

Quantities analysis_quantities(const AnalysisReport& report) {
  const Analysis& a = report.analysis;
  const AnalysisSummary& s = report.summary;
  const SeriesEstimate density = a.conditions->density(), T = a.conditions->temperature();
  Quantities list = {
      {"frames", "", a.frames},
      {"first", "ps", a.first},
      {"last", "ps", a.last},
      {"interval", "ps", a.interval},
      {"molecules", "", a.topology.size()},
      {"fit_deviation", "nm", a.deviation},
      {"interrupted", "", a.stopped},
      {"notes", "", s.notes},
      {"density", "g/cm3", scaled(density, 1 / units::gram_per_cm3)},
      {"density", "kg/m3", scaled(density, 1 / unit("kg/m3", Dimension::density)), "", "density"},
      {"temperature_source", "", s.temperature_source}};
  if (a.has_velocities)
    list.push_back({"temperature", "K", T, "", "temperature", ", of the velocities"});
  else if (s.temperature)
    list.push_back(
        row("temperature", fmt::format("{:g} K, {}", *s.temperature, s.temperature_source)));
  append(list, s.quantities);
  if (a.fixed) list.push_back({"frames_with_step_error", "", a.frames_with_step_error});
  append(list, {{"files", "", report.files}, row_of_files(report.files)});
  return list;
}

std::string analysis_json(const AnalysisReport& report) {
  return json_text(analysis_quantities(report));
}

std::string analysis_text(const AnalysisReport& report) {
  const Analysis& a = report.analysis;
  const std::string frames =
      a.frames == 1
          ? fmt::format("1 frame at {:g} ps", a.first)
          : fmt::format("{} frames from {:g} to {:g} ps{}", a.frames, a.first, a.last,
                        a.interval > 0 ? fmt::format(", {:.6g} ps apart", a.interval) : "");
  return fmt::format("{}, {} molecules\n\n", frames, a.topology.size()) +
         text_of(analysis_quantities(report));
}

}  // namespace polhode
