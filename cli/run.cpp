// SPDX-License-Identifier: MIT
// polhode run [FILE]: a trajectory with its energies, pictures and summary.
#include <fmt/core.h>

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "force_notes.hpp"
#include "interrupt.hpp"
#include "option_values.hpp"
#include "polhode/base/error.hpp"
#include "polhode/base/target.hpp"
#include "polhode/base/threads.hpp"
#include "polhode/io/frame_file.hpp"
#include "polhode/io/gro.hpp"
#include "polhode/io/nested_scheme_text.hpp"
#include "polhode/io/plot.hpp"
#include "polhode/io/quantity.hpp"
#include "polhode/io/table_file.hpp"
#include "polhode/run/near_forces.hpp"
#include "polhode/run/summary.hpp"
#include "progress.hpp"
#include "verbs.hpp"

namespace polhode::cli {
namespace {

struct Options {
  std::string file, scheme, step, length, output, threads, precision;
  bool force = false, json = false;
};

Config configured(const Options& o) {
  Config config = o.file.empty() ? default_config() : read_config(o.file);
  if (!o.precision.empty()) set_precision(config, precision_option(o.precision));
  if (!o.scheme.empty()) {
    scheme_option(o.scheme, "--scheme");
    config.integrator.scheme = o.scheme;
  }
  if (!o.step.empty()) config.integrator.step = positive_time(o.step, "--step");
  if (!o.length.empty()) config.run.length = positive_time(o.length, "--length");
  if (!o.output.empty()) config.output.prefix = o.output;
  return config;
}

/// The command with the options that change what is computed.
std::string typed(const Options& o) {
  return typed_command("polhode run", {{"", o.file},
                                       {"--scheme", o.scheme},
                                       {"--step", o.step},
                                       {"--length", o.length},
                                       {"--output", o.output}});
}

/// The files of a run, by their use.
struct Files {
  std::string energies, final_state, script, plot;
  std::vector<std::string> trajectories;

  explicit Files(const OutputSettings& output)
      : energies(output.prefix + "-energies.csv"), final_state(output.prefix + "-final.gro") {
    if (output.plot != "none") {
      script = output.prefix + "-energies.gp";
      plot = output.prefix + "-energies." + output.plot;
    }
    if (output.trajectory_every > 0)
      for (const std::string& format : output.formats)
        trajectories.push_back(output.prefix + "-trajectory." + format);
  }
  std::vector<std::string> all() const {
    std::vector<std::string> files = trajectories;
    files.push_back(energies);
    files.push_back(final_state);
    if (!plot.empty()) files.insert(files.end(), {script, plot});
    return files;
  }
};

/// What observers of a run see of its energies beside the atoms.
std::vector<Observable> observables(const Energies& e) {
  return {{"potential_energy", "kJ mol-1", e.potential()},
          {"kinetic_energy", "kJ mol-1", e.kinetic()},
          {"total_energy", "kJ mol-1", e.total()}};
}

double in_bar(double pressure) { return pressure / unit("bar", Dimension::pressure); }

Table energy_table(const std::vector<Energies>& samples, const Freedoms& freedoms) {
  Table table;
  table.columns = {{"time", "ps"},
                   {"total", "kJ/mol"},
                   {"potential", "kJ/mol"},
                   {"lennard_jones", "kJ/mol"},
                   {"coulomb", "kJ/mol"},
                   {"kinetic_translation", "kJ/mol"},
                   {"kinetic_rotation", "kJ/mol"},
                   {"temperature", "K"},
                   {"pressure", "bar"}};
  for (const Energies& e : samples)
    table.rows.push_back({e.time, e.total(), e.potential(), e.lennard_jones, e.coulomb,
                          e.translation, e.kinetic() - e.translation,
                          temperature(e.kinetic(), freedoms.all()), in_bar(e.pressure)});
  return table;
}

std::string verdict(const Drift& drift) {
  return drift.chance < significance ? "significant" : "not significant";
}

/// What the run was computed with.
struct Means {
  int threads;
  std::string target;
};

void print_summary(const RunSummary& s, const TrajectorySettings& t, const Means& means) {
  const auto percent = [](double x) { return 100 * x; };
  fmt::print("{} molecules, {} steps of {:g} fs with {}, {:.4g} ps, energies every {:g} fs\n\n",
             s.molecules, s.steps, t.step * 1000, name_of({t.scheme, t.inner}), s.length,
             s.sample * 1000);
  fmt::print(
      "R                     {:.4g} ± {:.2g} %   (rms of total energy {:.4g} over that of the "
      "potential {:.4g} kJ/mol)\n",
      percent(s.ratio.value), percent(s.ratio.error), s.total_fluctuation, s.potential_fluctuation);
  if (s.rounding > 0)
    fmt::print("R of rounding         {:.2g} %, estimated{}\n", percent(s.rounding),
               s.ratio.value < rounding_margin * s.rounding
                   ? "; R is not the scheme's any more: precision = \"double\" gives it"
                   : "");
  fmt::print("drift                 {:.3g} ± {:.2g} kJ/mol/ps, {} (chance {:.2g})\n",
             s.drift.rate.value, s.drift.rate.error, verdict(s.drift), s.drift.chance);
  fmt::print("potential energy      {:.4f} kJ/mol per molecule\n", s.potential);
  fmt::print("total energy          {:.4f} kJ/mol per molecule\n", s.total);
  fmt::print("temperature           {:.2f} K: translation {:.2f}, rotation", s.temperature,
             s.translation);
  for (std::size_t k = 0; k < 3; ++k)
    fmt::print(" {}", s.freedoms.rotation[k] > 0 ? fmt::format("{:.2f}", s.rotation[k]) : "-");
  const Freedoms& n = s.freedoms;
  fmt::print(" K\nfreedoms              {:.0f}: translation {:.0f}, rotation {:.0f} {:.0f} {:.0f}",
             n.all(), n.translation, n.rotation[0], n.rotation[1], n.rotation[2]);
  fmt::print("\npressure              {:.0f} ± {:.0f} bar", in_bar(s.pressure.value),
             in_bar(s.pressure.error));
  fmt::print("\ntotal momentum        {:.2g} u nm/ps\n", s.momentum);
  fmt::print("force evaluations     {} ({:.4g} per ps)", s.force_evaluations,
             static_cast<double>(s.force_evaluations) / s.length);
  if (t.inner)
    fmt::print(", of near forces {} ({:.4g} per ps)", s.near_evaluations,
               static_cast<double>(s.near_evaluations) / s.length);
  if (s.measurements > 1) fmt::print(", and {} for energies alone", s.measurements);
  fmt::print("\nneighbour list        {} rebuilds\n", s.list_rebuilds);
  const double all = s.timings.all();
  fmt::print(
      "time                  {:.2f} s: forces {:.0f} %, {}list {:.0f} %, drifts and kicks {:.0f} "
      "%, "
      "energies and output {:.0f} %\n",
      all, percent(s.timings.forces / all),
      t.inner ? fmt::format("near forces {:.0f} %, ", percent(s.timings.near / all)) : "",
      percent(s.timings.list / all), percent(s.timings.motion / all),
      percent(s.timings.measurement / all));
  fmt::print("speed                 {:.4g} ns/day with {} {}, instruction set {}\n", s.ns_per_day,
             means.threads, means.threads == 1 ? "thread" : "threads", means.target);
}

nlohmann::json as_json(const RunSummary& s, const TrajectorySettings& t, const Means& means,
                       const Files& files, bool stopped) {
  return {{"molecules", s.molecules},
          {"scheme", text_of({t.scheme, t.inner})},
          {"step_fs", t.step * 1000},
          {"steps", s.steps},
          {"length_ps", s.length},
          {"sample_fs", s.sample * 1000},
          {"interrupted", stopped},
          {"R", s.ratio.value},
          {"R_error", s.ratio.error},
          {"R_rounding", s.rounding},
          {"rms_total_kJ_per_mol", s.total_fluctuation},
          {"rms_potential_kJ_per_mol", s.potential_fluctuation},
          {"drift_kJ_per_mol_ps", s.drift.rate.value},
          {"drift_error", s.drift.rate.error},
          {"drift_chance", s.drift.chance},
          {"drift_significant", s.drift.chance < significance},
          {"potential_kJ_per_mol", s.potential},
          {"total_kJ_per_mol", s.total},
          {"temperature_K", s.temperature},
          {"temperature_translation_K", s.translation},
          {"temperature_rotation_K", s.rotation},
          {"freedoms_translation", s.freedoms.translation},
          {"freedoms_rotation", s.freedoms.rotation},
          {"pressure_bar", in_bar(s.pressure.value)},
          {"pressure_error_bar", in_bar(s.pressure.error)},
          {"momentum", s.momentum},
          {"force_evaluations", s.force_evaluations},
          {"near_evaluations", s.near_evaluations},
          {"force_evaluations_for_energies", s.measurements},
          {"list_rebuilds", s.list_rebuilds},
          {"seconds",
           {{"all", s.timings.all()},
            {"forces", s.timings.forces},
            {"near", s.timings.near},
            {"list", s.timings.list},
            {"motion", s.timings.motion},
            {"energies_and_output", s.timings.measurement}}},
          {"ns_per_day", s.ns_per_day},
          {"threads", means.threads},
          {"target", means.target},
          {"files", files.all()}};
}

int run(const Options& o) {
  const Config config = configured(o);
  const NestedScheme scheme = nested_scheme_of(config.integrator.scheme);
  const TrajectorySettings settings{scheme.outer,      config.integrator.step,   config.run.length,
                                    config.run.sample, config.integrator.lambda, scheme.inner};
  if (settings.length < settings.step * (1 - 1e-9))
    throw Error(
        fmt::format("length {:g} fs is shorter than the step of {:g} fs; ask for one step at least",
                    settings.length * 1000, settings.step * 1000),
        config.source);
  Workers workers(threads_wanted(o.threads));
  System system = assembled(config);
  ForceField forces(system.topology, system.forces, system.state.box, workers);
  check_near(system.forces, scheme, config.source);
  const Files files(config.output);
  for (const std::string& file : files.all()) refuse_existing(file, o.force);

  const Provenance provenance{POLHODE_VERSION, typed(o), config.text, name(current_target()),
                              config.system.seed};
  const Means means{workers.threads(), provenance.target};
  fmt::print(stderr, "polhode {}: {} molecules, {}, {} in {:g} fs steps, target {}, threads {}\n",
             POLHODE_VERSION, system.topology.size(), config.source, name_of(scheme),
             settings.step * 1000, means.target, means.threads);
  note_forces(system);
  if (system.fit_deviation > 1e-4)
    fmt::print(stderr, "note: atoms of the start lay up to {:.4f} nm from the rigid models\n",
               system.fit_deviation);

  catch_interrupts();
  if (config.run.equilibrate > 0) {
    Progress progress("equilibrating");
    double now = 0;
    const Watch watch{[&](std::size_t, const State& state, const Energies&) {
                        now = std::max(now, state.time);
                        progress.show(now / config.run.equilibrate);
                      },
                      interrupted};
    if (!equilibrate(system, forces, config.run.equilibrate, watch, workers)) {
      fmt::print(stderr, "interrupted while equilibrating; nothing was written\n");
      return 130;
    }
  }

  const ForceNoise noise = force_noise(system, workers);
  // Frames are appended as the run goes, so that an interrupt leaves what was done.
  std::vector<std::unique_ptr<FrameWriter>> frames;
  for (const std::string& file : files.trajectories)
    frames.push_back(create_frames(file, system.topology, config.output.choice()));
  const auto steps_per_frame = static_cast<std::size_t>(
      std::max(1.0, config.output.trajectory_every / settings.step + 1e-9));
  std::size_t next_frame = 0;
  Trajectory t;
  {
    Progress progress("running");
    const Watch watch{
        [&](std::size_t step, const State& state, const Energies& e) {
          progress.show(static_cast<double>(step) / static_cast<double>(settings.steps()));
          if (frames.empty() || step < next_frame) return;
          for (const auto& file : frames) file->write(state, observables(e));
          next_frame = step + steps_per_frame;
        },
        interrupted};
    t = trajectory(system, forces, settings, watch, workers);
  }
  if (t.samples.empty()) throw RunError(t.failure);
  if (t.stopped)
    fmt::print(stderr, "interrupted after {} steps; what was computed follows\n", t.steps);

  const RunSummary s = summary(system, forces, settings, t, noise);
  write_file(files.energies, [&](std::ostream& out) {
    write_csv(out, energy_table(t.samples, s.freedoms), provenance);
  });
  if (!t.failure.empty()) {
    fmt::print(stderr, "the energies until then are in {}\n", files.energies);
    throw RunError(t.failure);
  }
  write_file(files.final_state,
             [&](std::ostream& out) { write_gro(out, system.state, system.topology); });
  if (!files.plot.empty())
    energy_plot(
        files.energies,
        fmt::format("{}, {} at {:g} fs", config.source, name_of(scheme), settings.step * 1000),
        config.output.plot, std::cerr);

  if (o.json) {
    fmt::print("{}\n", as_json(s, settings, means, files, t.stopped).dump(2));
  } else {
    print_summary(s, settings, means);
    fmt::print("files                ");
    for (const std::string& file : files.all()) fmt::print(" {}", file);
    fmt::print("\n");
  }
  return t.stopped ? 130 : 0;
}

}  // namespace

Action run_verb(CLI::App& app) {
  auto o = std::make_shared<Options>();
  app.add_option("FILE", o->file, "run file (TOML); without it: 512 TIP4P waters");
  app.add_option("--scheme", o->scheme, "instead of the run file's: a name, or stages as text");
  app.add_option("--step", o->step, "instead of the run file's: \"2 fs\"");
  app.add_option("--length", o->length, "instead of the run file's: \"15 ps\"");
  app.add_option("--output", o->output, "prefix of the output files, instead of the run file's");
  app.add_option("--precision", o->precision,
                 "of the pairs, instead of the run file's: double or mixed");
  app.add_option("--threads", o->threads,
                 "that share the work of a run; without it: one for each core allowed");
  app.add_flag("--force", o->force, "overwrite output files that exist");
  app.add_flag("--json", o->json, "print the summary as JSON");
  return [o] { return run(*o); };
}

}  // namespace polhode::cli
