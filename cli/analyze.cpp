// SPDX-License-Identifier: MIT
// polhode analyze TRAJECTORY: structure, dynamics and dielectric constant from its frames.
#include <fmt/core.h>

#include <algorithm>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "analyze_report.hpp"
#include "interrupt.hpp"
#include "option_values.hpp"
#include "polhode/base/error.hpp"
#include "polhode/base/instruction_set.hpp"
#include "polhode/base/threads.hpp"
#include "polhode/io/config.hpp"
#include "polhode/io/frame_file.hpp"
#include "polhode/io/molecule_file.hpp"
#include "polhode/io/plot.hpp"
#include "polhode/run/simulation/system.hpp"
#include "progress.hpp"
#include "streams.hpp"
#include "verbs.hpp"

namespace polhode::cli {
namespace {

struct Options {
  std::string trajectory, run, molecules, names, what, output = "polhode-analysis", plot = "svg";
  std::string from, interval, window, fit, pairs, cutoff, bin, viscosity, temperature,
      electrostatics, threads;
  bool force = false, json = false;
};

/// Splits "a, b" into words.
std::vector<std::string> words(const std::string& text) {
  std::vector<std::string> found;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const auto first = part.find_first_not_of(' '), last = part.find_last_not_of(' ');
    if (first != part.npos) found.push_back(part.substr(first, last - first + 1));
  }
  return found;
}

/// "tip4p 512, na 4": models with their counts, in the order of the file.
Topology molecules_option(const std::string& text) {
  Topology topology;
  for (const std::string& word : words(text)) {
    std::istringstream parts(word);
    std::string model;
    std::size_t count = 0;
    parts >> model;
    if (!(parts >> std::ws).eof() && (!(parts >> count) || !parts.eof() || count == 0))
      throw Error(
          fmt::format("--molecules \"{}\": '{}' must be a model and its count; write for "
                      "example \"tip4p 512, na-tip4p-ew 4\"",
                      text, word));
    topology.parts.push_back({read_molecule(model), count});
  }
  if (topology.parts.empty())
    throw Error("--molecules names no model; write for example \"tip4p 512\"");
  if (topology.parts.size() > 1)
    for (const auto& [molecule, count] : topology.parts)
      if (count == 0)
        throw Error(
            fmt::format("--molecules \"{}\": '{}' has no count; the count can be left out only if "
                        "there is one model",
                        text, molecule.name));
  return topology;
}

/// Takes from the forces what the dielectric constant depends on.
void set_surroundings(SummarySettings& settings, const ForceSettings& forces) {
  switch (forces.electrostatics) {
    case Electrostatics::pme:
      settings.surroundings_permittivity = tin_foil;
      break;
    case Electrostatics::reaction_field:
      settings.surroundings_permittivity = forces.dielectric;
      break;
    case Electrostatics::coulomb:
    case Electrostatics::damped_shifted_force:
      settings.no_surroundings =
          "dipole fluctuations give no dielectric constant if electrostatics is truncated or "
          "switched; pme or a reaction field is needed";
  }
}

void set_surroundings(SummarySettings& settings, const std::string& electrostatics) {
  ForceSettings forces;
  forces.electrostatics = named_option<Electrostatics>(electrostatics, "--electrostatics");
  set_surroundings(settings, forces);
}

double positive(const std::string& text, Dimension dimension, const std::string& option) {
  const double value = quantity(text, dimension, option);
  if (!(value > 0)) throw Error(fmt::format("{} = \"{}\" must be above 0", option, text));
  return value;
}

AnalysisSettings analysis_settings(const Options& o) {
  AnalysisSettings s;
  for (const std::string& name : words(o.what)) s.what.insert(observable(name));
  s.from = o.from.empty() ? -std::numeric_limits<double>::infinity()
                          : quantity(o.from, Dimension::time, "--from");
  if (!o.interval.empty()) s.interval = positive_time(o.interval, "--interval");
  if (!o.window.empty()) s.window = positive_time(o.window, "--window");
  if (!o.cutoff.empty()) s.cutoff = positive(o.cutoff, Dimension::length, "--cutoff");
  if (!o.bin.empty()) s.bin = positive(o.bin, Dimension::length, "--bin");
  for (const std::string& word : words(o.pairs)) {
    const auto dash = word.find('-');
    if (dash == word.npos || dash == 0 || dash + 1 == word.size())
      throw Error(fmt::format(
          "--pairs: '{}' must be two site names; write for example \"OW-OW, OW-HW\"", word));
    s.pairs.push_back({word.substr(0, dash), word.substr(dash + 1)});
  }
  if (s.cutoff && *s.cutoff < s.bin)
    throw Error(
        fmt::format("--cutoff of {:g} nm is shorter than a bin of {:g} nm; ask for a longer "
                    "one",
                    *s.cutoff, s.bin));
  return s;
}

SummarySettings summary_settings(const Options& o, const std::optional<Config>& config) {
  SummarySettings s;
  s.no_surroundings = "it depends on the electrostatics of the run; give --run or --electrostatics";
  if (config) set_surroundings(s, config->forces);
  if (!o.electrostatics.empty()) set_surroundings(s, o.electrostatics);
  if (!o.temperature.empty())
    s.temperature = positive(o.temperature, Dimension::temperature, "--temperature");
  if (!o.viscosity.empty())
    s.viscosity = positive(o.viscosity, Dimension::viscosity, "--viscosity");
  if (!o.fit.empty()) {
    const std::vector<std::string> ends = words(o.fit);
    if (ends.size() != 2)
      throw Error(
          fmt::format("--fit \"{}\" must be two lags; write for example \"2 ps, 10 ps\"", o.fit));
    s.fit = FitWindow{quantity(ends[0], Dimension::time, "--fit"),
                      quantity(ends[1], Dimension::time, "--fit")};
    if (!(0 <= s.fit->from && s.fit->from < s.fit->to))
      throw Error(
          fmt::format("--fit \"{}\" must begin at 0 or later and end after its beginning; write "
                      "for example \"2 ps, 10 ps\"",
                      o.fit));
  }
  return s;
}

/// The files that may be written, depending on what the frames allow.
std::vector<std::string> outputs(const Options& o, const AnalysisSettings& settings) {
  std::set<Observable> what = settings.what;
  if (what.empty())
    for (const std::string& name : observable_names()) what.insert(observable(name));
  std::vector<std::string> files;
  for (const std::string& name : file_names(what))
    for (const std::string& extension : {std::string("csv"), std::string("gp"), o.plot})
      if (extension == "csv" || o.plot != "none")
        files.push_back(fmt::format("{}-{}.{}", o.output, name, extension));
  return files;
}

std::string command_line(const Options& o) {
  return typed_command("polhode analyze", {{"", o.trajectory},
                                           {"--run", o.run},
                                           {"--molecules", o.molecules},
                                           {"--names", o.names},
                                           {"--what", o.what},
                                           {"--from", o.from},
                                           {"--interval", o.interval},
                                           {"--window", o.window},
                                           {"--fit", o.fit},
                                           {"--pairs", o.pairs},
                                           {"--cutoff", o.cutoff},
                                           {"--bin", o.bin},
                                           {"--viscosity", o.viscosity},
                                           {"--temperature", o.temperature},
                                           {"--electrostatics", o.electrostatics}});
}

int run_analyze(const Options& o) {
  if (o.run.empty() == o.molecules.empty())
    throw Error(
        "the molecules of the trajectory are not known; give one of --run water.toml and "
        "--molecules \"tip4p 512\"");
  if (std::find(plot_formats.begin(), plot_formats.end(), o.plot) == plot_formats.end())
    throw Error(fmt::format("--plot = \"{}\" {}", o.plot, must_be_one_of(plot_formats, o.plot)));
  std::optional<Config> config;
  if (!o.run.empty()) config = read_config(o.run);
  const Topology topology = config ? build_topology(config->system) : molecules_option(o.molecules);
  const AnalysisSettings settings = analysis_settings(o);
  const SummarySettings numbers = summary_settings(o, config);
  Workers workers(requested_threads(o.threads));
  std::optional<Frame> names;
  if (!o.names.empty()) {
    names.emplace();
    if (!open_frames(o.names)->next(*names))
      throw Error(fmt::format("'{}' contains no frame; give a file with at least one", o.names));
  }
  const auto reader = open_frames(o.trajectory, names ? &*names : nullptr);
  for (const std::string& file : outputs(o, settings)) refuse_existing(file, o.force);

  catch_interrupts();
  Analysis result;
  {
    Progress progress("reading");
    const AnalysisWatch watch{[&](std::size_t frames, double time) {
                                progress.show(fmt::format("{} frames, {:g} ps", frames, time));
                              },
                              interrupted};
    result = analyze(*reader, topology, settings, watch, workers);
  }
  if (result.stopped) log("interrupted after {} frames; their results follow\n", result.frames);
  const AnalysisSummary s = summary(result, numbers, workers);
  if (result.deviation > 1e-4)
    log("note: atoms deviate by up to {:.4f} nm from the rigid models\n", result.deviation);
  for (const std::string& note : s.notes) log("note: {}\n", note);

  const Provenance provenance{POLHODE_VERSION, command_line(o), config ? config->text : o.molecules,
                              name(current_instruction_set()), config ? config->system.seed : 0};
  std::vector<std::string> written;
  for (AnalysisFile& file : analysis_files(result, s, workers)) {
    const std::string csv = fmt::format("{}-{}.csv", o.output, file.name);
    write_file(csv, [&](std::ostream& out) { write_csv(out, file.table, provenance); });
    written.push_back(csv);
    if (o.plot == "none") continue;
    file.figure.csv = csv;
    if (curves_plot(file.figure, o.plot, std::cerr))
      written.push_back(fmt::format("{}-{}.{}", o.output, file.name, o.plot));
  }
  if (o.json) {
    nlohmann::json json = as_json(result, s);
    json["files"] = written;
    fmt::print("{}\n", json.dump(2));
  } else {
    print_summary(result, s);
    fmt::print("files                ");
    for (const std::string& file : written) fmt::print(" {}", file);
    fmt::print("\n");
  }
  return result.stopped ? 130 : 0;
}

}  // namespace

Action analyze_verb(CLI::App& app) {
  auto o = std::make_shared<Options>();
  app.add_option("TRAJECTORY", o->trajectory,
                 "trajectory or coordinate file; the format follows from its extension")
      ->required();
  app.add_option("--run", o->run,
                 "run file of the trajectory, for its molecules and electrostatics");
  app.add_option("--molecules", o->molecules,
                 "instead of a run file: \"tip4p 512, na-tip4p-ew 4\", in the order of the file");
  app.add_option("--names", o->names, "coordinate file with the names of the atoms");
  app.add_option("--what", o->what,
                 "any of rdf, msd, rotation, velocity, dielectric, density; default: all that the "
                 "frames allow");
  app.add_option("--output", o->output, "prefix of the output files; default: polhode-analysis");
  app.add_option("--from", o->from, "ignore frames before this time: \"10 ps\"");
  app.add_option("--interval", o->interval,
                 "time between frames, instead of the times in the file: \"0.1 ps\"");
  app.add_option("--window", o->window, "maximum lag of correlations; default: \"10 ps\"");
  app.add_option("--fit", o->fit,
                 "range of lags of the line fitted for D: \"2 ps, 10 ps\"; default: from a fifth "
                 "of the maximum lag to the maximum lag");
  app.add_option("--pairs", o->pairs,
                 "site pairs of g(r): \"OW-OW, OW-HW\"; HW means HW1 and HW2; default: all pairs");
  app.add_option("--cutoff", o->cutoff,
                 "maximum distance of g(r); default: \"1 nm\", or half of the shortest edge");
  app.add_option("--bin", o->bin, "bin width of g(r); default: \"0.002 nm\"");
  app.add_option("--viscosity", o->viscosity,
                 "viscosity of the liquid, \"0.855 mPa s\", for the Yeh-Hummer finite-size "
                 "correction of D; default: the published value of the model");
  app.add_option("--temperature", o->temperature,
                 "\"298 K\"; default: the temperature of the velocities");
  app.add_option("--electrostatics", o->electrostatics,
                 "instead of the run file's: pme, reaction-field (of 78.5) or coulomb");
  app.add_option("--plot", o->plot, "svg, png or none; default: svg");
  app.add_option("--threads", o->threads,
                 "number of threads; default: one for each available core");
  app.add_flag("--force", o->force, "overwrite output files that exist");
  app.add_flag("--json", o->json, "print the summary as JSON");
  return [o] { return run_analyze(*o); };
}

}  // namespace polhode::cli
