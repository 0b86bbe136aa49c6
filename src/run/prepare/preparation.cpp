// SPDX-License-Identifier: MIT
#include "polhode/run/prepare/preparation.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "base/output_error.hpp"
#include "base/stopwatch.hpp"
#include "io/coordinates/gro.hpp"
#include "io/files/write_file.hpp"
#include "io/settings/output_units.hpp"
#include "io/settings/prepared_run_file.hpp"
#include "io/settings/quantity.hpp"
#include "polhode/base/units.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/math/random.hpp"
#include "polhode/run/simulation/trajectory/propagator.hpp"
#include "run/output_files.hpp"
#include "run/prepare/compressibility.hpp"
#include "run/simulation/files/checkpoint.hpp"
#include "run/simulation/report/warning_rules.hpp"
#include "run/simulation/system/relaxation.hpp"
#include "run/simulation/system/stable_step.hpp"
#include "run/simulation/system/system_notes.hpp"

namespace polhode {
namespace {

constexpr MinimisationSettings bounds{.force = 100, .torque = 10};
constexpr double friction = 5;                             // friction of the Langevin thermostat
                                                           // [1/ps]
constexpr double first_step = 0.001, max_step = 0.002;     // time steps [ps]
constexpr std::uint64_t streams = std::uint64_t{1} << 40;  // number of derived seeds; other uses
                                                           // need fewer

double kg_per_m3(double density) { return density / unit("kg/m3", Dimension::density); }

/// A stage of the preparation, with separate random numbers and statistics.
struct Stage {
  const char* name;
  double length;  ///< length [ps]
  bool constant_pressure;
};

std::vector<Stage> stages_of(const Config& config) {
  const PreparationSettings& p = config.prepare;
  std::vector<Stage> stages = {{"NVT", p.nvt / 2, false}, {"NVT", p.nvt / 2, false}};
  if (config.ensemble.barostat)  // barostat moves adapt after each part
    for (const double part : {8, 8, 4, 2}) stages.push_back({"NPT", p.npt / part, true});
  std::erase_if(stages, [](const Stage& stage) { return stage.length < 2 * max_step; });
  if (stages.empty())
    throw Error(
        "the preparation has no dynamics, since nvt and npt are 0 ps; set one of these lengths "
        "above 0 ps, or use 'polhode minimise'",
        config.source);
  return stages;
}

struct PreparationFiles {
  std::string state, checkpoint, run_file;
  explicit PreparationFiles(const std::string& prefix)
      : state(prefix + "-prepared.gro"),
        checkpoint(prefix + "-prepared.bin"),
        run_file(prefix + "-prepared.toml") {}
  std::vector<std::string> all() const { return {state, checkpoint, run_file}; }
};

/// The identity of a preparation: the identity of the run, and the lengths of the stages. The
/// identity must be the same when the preparation is resumed.
std::string identity_of(const Config& config, const System& system) {
  const std::string run = run_identity(config, system);
  const std::string stages = fmt::format("prepare.nvt = {:.12g} ps\nprepare.npt = {:.12g} ps\n",
                                         config.prepare.nvt, config.prepare.npt);
  return text_hash(run + stages) + run.substr(run.find('\n')) + stages;
}

/// Scales momenta so that the total energy equals its canonical mean. After this scaling, a run at
/// constant energy has the temperature of the thermostat.
void set_energy(System& system, double mean_total, Workers& workers) {
  State& state = system.state;
  ForceField forces(system.topology, system.forces, state.box, workers);
  Load load;
  forces(state, load);
  const Energies now = energies(state, system.bodies, load, workers);
  const double kinetic = mean_total - now.potential();
  if (!(kinetic > 0) || !(now.kinetic() > 0)) return;
  const double factor = std::sqrt(kinetic / now.kinetic());
  scale(state.p, factor);
  scale(state.ell, factor);
}

/// A warning if the volume still changes by more than 0.5 %.
std::optional<Warning> density_warning(const Drift& slope, double length, double volume) {
  constexpr double min_change = 0.005;
  const double change = slope.rate.value * length / volume;
  const bool known = slope.known == Known::yes;
  if ((known && slope.p_value > significance_level) || !(std::abs(change) >= min_change))
    return std::nullopt;
  return Warning{"density", change, min_change,
                 fmt::format("the volume is still {}: by {:.2g} % in the last {:g} ps{}",
                             change > 0 ? "growing" : "shrinking", 100 * std::abs(change), length,
                             known ? "" : ", a time too short for an error estimate"),
                 "prepare longer: npt = \"500 ps\" in [prepare], or give a density"};
}

/// A warning if the mean pressure shows that the density will still change by more than 0.5 %.
std::optional<Warning> pressure_warning(const SeriesEstimate& pressure, const BarostatSettings& b) {
  constexpr double min_change = 0.005;
  const double bar = unit("bar", Dimension::pressure);
  const double bound = std::max(three_sigma(pressure), min_change / b.compressibility);
  if (pressure.known != Known::yes || std::abs(pressure.value - b.pressure) <= bound)
    return std::nullopt;
  return Warning{"barostat", pressure.value / bar, bound / bar,
                 fmt::format("the mean pressure is {:.3g} bar instead of {:g} bar: the volume has "
                             "not reached equilibrium",
                             pressure.value / bar, b.pressure / bar),
                 "prepare longer: npt = \"500 ps\" in [prepare], or give a density"};
}

class Preparation {
 public:
  Preparation(const Config& config, const OutputOptions& options, const Callbacks& callbacks,
              Workers& workers)
      : config_(config),
        options_(options),
        callbacks_(callbacks),
        workers_(workers),
        stages_(stages_of(config)),
        files_(config.output.prefix) {}

  PreparationReport perform() {
    PreparationReport report;
    choose_density(report);
    config_.run.minimise = true;
    System system = build_system(config_);
    report.molecules = system.topology.size();
    note_molecules(system, callbacks_);
    note_forces(system, callbacks_);
    identity_ = identity_of(config_, system);
    resumes_ = find_checkpoint();
    if (resumes_) system.state = at_.state;
    bool continues = resumes_ || begin(system);
    while (continues && progress_.stage < stages_.size()) continues = run_stage(system);
    report.minimisation = progress_.minimisation;
    report.compressibility = progress_.compressibility;
    if (progress_.minimisation.end != MinimisationEnd::stopped) {
      report.checkpoint = files_.checkpoint;
      report.files = {files_.checkpoint};
    }
    if (!continues) return report;
    system.state = at_.state;
    report.properties = properties(system);
    if (const SeriesEstimate& measured = report.properties->compressibility;
        report.compressibility > 0 && measured.known == Known::yes)
      report.compressibility = measured.value;
    write_files(system, report);
    return report;
  }

 private:
  void choose_density(PreparationReport& report) {
    SystemSettings& s = config_.system;
    if (!s.initial_configuration.empty()) return;
    const Topology topology = build_topology(s);
    report.estimated = !s.density && !s.box && config_.ensemble.barostat;
    if (report.estimated) s.density = estimated_density(topology);
    if (s.box) report.lattice_density = topology.mass() / Box{*s.box}.volume();
    if (s.density) report.lattice_density = *s.density;
    if (report.estimated)
      callbacks_.note(
          fmt::format("note: no density is given, so the lattice has {:.0f} kg/m3, estimated from "
                      "the diameters of the sites; the barostat changes this density",
                      kg_per_m3(*s.density)));
  }

  TrajectorySettings settings_of(std::size_t stage) const {
    TrajectorySettings settings{.scheme = scheme_of("baoab"),
                                .step = progress_.step,
                                .length = stages_[stage].length,
                                .sample = 0.02,
                                .seed = derived_seed(config_.system.seed, streams + stage)};
    settings.ensemble.temperature = config_.system.temperature;
    settings.ensemble.thermostat = Langevin{friction, friction};
    if (!stages_[stage].constant_pressure) return settings;
    settings.ensemble.barostat = config_.ensemble.barostat;
    if (progress_.compressibility > 0)
      settings.ensemble.barostat->compressibility = progress_.compressibility;
    return settings;
  }

  /// Finds the checkpoint from which to resume, if resuming is requested and a checkpoint exists.
  bool find_checkpoint() {
    const bool resumes = options_.existing == ExistingFiles::resume;
    const bool exists = std::filesystem::exists(files_.checkpoint);
    if (exists && options_.existing == ExistingFiles::refuse)
      throw OutputError(fmt::format("'{}' exists: the preparation was started before; resume it, "
                                    "give another output, or start over",
                                    files_.checkpoint),
                        true);
    if (!resumes || !exists) {
      check_outputs(files_.all(), options_.existing, inputs_of(config_));
      if (resumes)
        callbacks_.note("note: there is no checkpoint; the preparation starts from the beginning");
      return false;
    }
    Checkpoint found = read_checkpoint_of(files_.checkpoint, identity_);
    progress_ = found.preparation.value();
    at_ = std::move(found.at);
    return true;
  }

  void save(RunState at) {
    at_ = std::move(at);
    write_checkpoint(
        {files_.checkpoint, ""},
        {.identity = identity_, .command = options_.command, .at = at_, .preparation = progress_});
  }

  /// Begins the preparation.
  /// @return false if the preparation was interrupted
  bool begin(System& system) {
    progress_.minimisation = minimise(system, bounds, watch_of(callbacks_), workers_);
    callbacks_.note(description(progress_.minimisation));
    if (progress_.minimisation.end == MinimisationEnd::stopped) return false;
    check_separated(system, progress_.minimisation);
    draw_momenta(system, config_.system.seed);
    for (const std::string& file : files_.all()) std::filesystem::remove(file);
    return true;
  }

  Trajectory run(System& system, const TrajectorySettings& settings) {
    const std::size_t stage = progress_.stage;
    double all = 0, before = 0;
    for (std::size_t k = 0; k < stages_.size(); ++k) {
      if (k < stage) before += stages_[k].length;
      all += stages_[k].length;
    }
    const std::string name = stages_[stage].name;
    const auto show = [&](std::size_t steps, const State& state, const Energies&) {
      const double now = static_cast<double>(steps) * settings.step;
      callbacks_.report({"preparing", (before + now) / all,
                         fmt::format("{}, {:.0f} kg/m3", name,
                                     kg_per_m3(system.topology.mass() / state.box.volume()))});
    };
    Stopwatch since_checkpoint;
    const Watch watch{
        .sample = show,
        .stop = callbacks_.stop,
        .due = [&] { return since_checkpoint.seconds() >= config_.output.checkpoint_every; },
        .checkpoint =
            [&](RunState at) {
              save(std::move(at));
              since_checkpoint = Stopwatch();
            }};
    ForceField forces(system.topology, system.forces, system.state.box, workers_);
    const std::optional<RunState> from =
        std::exchange(resumes_, false) ? std::optional(at_) : std::nullopt;
    Trajectory trajectory =
        run_trajectory(system, forces, settings, watch, workers_, from ? &*from : nullptr);
    if (!trajectory.failure.empty())
      throw RunError(fmt::format(
          "the preparation blew up in its {} stage, after {:g} ps of {:g} ps: {}; use a lower "
          "density, or another initial configuration",
          name, before + static_cast<double>(trajectory.steps) * settings.step, all,
          trajectory.cause));
    return trajectory;
  }

  /// Sets up the next stage. At this point the forces have the usual size in a liquid, and at
  /// constant pressure the volume has changed.
  void set_up_next(const System& system, const TrajectorySettings& settings,
                   const Trajectory& trajectory) {
    constexpr double tenth_of_fs = 1e-4;
    if (settings.ensemble.barostat && !config_.gives("barostat.compressibility")) {
      const EnergyStatistics& energies = trajectory.statistics.energies;
      const BarostatSettings& barostat = *settings.ensemble.barostat;
      const double kT = units::boltzmann * settings.ensemble.temperature;
      progress_.compressibility = next_compressibility(energies, barostat, settings.length, kT);
      callbacks_.note(
          "compressibility " +
          compressibility_text(measured_compressibility(energies, barostat, settings.length, kT),
                               progress_.compressibility));
    }
    const double stable = max_stable_step(system, system.state, settings, workers_);
    progress_.step =
        std::clamp(std::floor(stable / tenth_of_fs) * tenth_of_fs, tenth_of_fs, max_step);
  }

  /// Runs a stage.
  /// @return false if the stage was interrupted
  bool run_stage(System& system) {
    const TrajectorySettings settings = settings_of(progress_.stage);
    callbacks_.note(
        fmt::format("{} for {:g} ps in steps of {:g} fs{}", stages_[progress_.stage].name,
                    settings.length, settings.step * units::fs_per_ps,
                    resumes_ ? fmt::format(", resuming after {:g} ps",
                                           static_cast<double>(at_.steps) * settings.step)
                             : ""));
    const Trajectory trajectory = run(system, settings);
    if (trajectory.stopped) return false;
    if (progress_.stage + 1 == stages_.size()) {
      finish(system, trajectory);
    } else {
      set_up_next(system, settings, trajectory);
      ++progress_.stage;
    }
    return true;
  }

  /// Writes the results. The last checkpoint contains the final state, and the samples of the last
  /// stage.
  void finish(System& system, const Trajectory& trajectory) {
    if (!config_.ensemble.thermostat && !config_.ensemble.hybrid_monte_carlo)
      set_energy(system, trajectory.statistics.energies.total(), workers_);
    system.state.time = 0;
    RunState last = at_;
    last.state = system.state;
    last.statistics = trajectory.statistics;
    ++progress_.stage;
    save(std::move(last));
  }

  /// Computes the properties from the last checkpoint.
  PreparedProperties properties(System& system) const {
    const TrajectorySettings settings = settings_of(stages_.size() - 1);
    ForceField forces(system.topology, system.forces, system.state.box, workers_);
    Propagator last(system, forces, settings, workers_);
    last.resume_from(at_);
    const Trajectory trajectory = last.trajectory();
    const EnergyStatistics& energies = trajectory.statistics.energies;
    PreparedProperties p{summary(system, settings, trajectory), energies.volume(), {}};
    const double mass = system.topology.mass(), V = p.density.value;
    if (const auto& barostat = settings.ensemble.barostat) {
      p.pressure = barostat->pressure;
      p.compressibility = measured_compressibility(
          energies, *barostat, settings.length, units::boltzmann * settings.ensemble.temperature);
      p.moves_compressibility = barostat->compressibility;
    }
    p.density.value = mass / V;
    p.density.error *= mass / (V * V);
    p.warnings =
        warnings_of_results(p.summary, TargetTemperature{settings.ensemble.temperature, false});
    if (const auto& barostat = settings.ensemble.barostat)
      append(p.warnings, {density_warning(energies.volume_drift(), p.summary.length, V),
                          pressure_warning(p.summary.pressure, *barostat)});
    append(p.warnings, {cutoff_of_ions(system)});
    return p;
  }

  void write_files(const System& system, PreparationReport& report) {
    config_.system.topology.shapes = system.shapes;
    if (report.compressibility > 0)
      config_.ensemble.barostat->compressibility = report.compressibility;
    const auto write = [&](const std::string& file, const auto& text) {
      // Existing files of a finished preparation are not written again, because the user may have
      // edited the run file.
      if (options_.existing == ExistingFiles::resume && std::filesystem::exists(file)) return;
      write_file(file, text);
    };
    write(files_.state, [&](std::ostream& out) { write_gro(out, system.state, system.topology); });
    write(files_.run_file, [&](std::ostream& out) {
      out << prepared_run_file(config_, files_.state, files_.checkpoint, files_.run_file);
    });
    report.run_file = files_.run_file;
    report.files = files_.all();
  }

  Config config_;
  OutputOptions options_;
  const Callbacks& callbacks_;
  Workers& workers_;
  std::vector<Stage> stages_;
  PreparationFiles files_;
  std::string identity_;
  PreparationProgress progress_{.step = first_step};
  RunState at_;  // state at the last checkpoint
  bool resumes_ = false;
};

}  // namespace

PreparationReport prepare(const Config& config, const OutputOptions& options,
                          const Callbacks& callbacks, Workers& workers) {
  const std::string& prefix = config.output.prefix;
  check_prefix(prefix, PreparationFiles(prefix).all());
  const OutputLock lock(prefix + "-prepare.lock", callbacks);
  return Preparation(config, options, callbacks, workers).perform();
}

}  // namespace polhode
