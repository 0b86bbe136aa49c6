// SPDX-License-Identifier: MIT
#include "polhode/run/prepare/preparation.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "polhode/base/error.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/io/gro.hpp"
#include "polhode/io/output_units.hpp"
#include "polhode/io/prepared_run_file.hpp"
#include "polhode/io/quantity.hpp"
#include "polhode/math/random.hpp"
#include "polhode/run/simulation/relaxation.hpp"
#include "polhode/run/simulation/stable_step.hpp"
#include "polhode/run/simulation/system_notes.hpp"

namespace polhode {
namespace {

constexpr MinimisationSettings bounds{.force = 100, .torque = 10};
constexpr double friction = 5;                             // of the Langevin thermostat [1/ps]
constexpr double first_step = 0.001, max_step = 0.002;     // [ps]
constexpr std::uint64_t streams = std::uint64_t{1} << 40;  // of derived seeds: others use less

double g_per_cm3(double density) { return density / unit("g/cm3", Dimension::density); }

/// Half of a stage. The second half has its own random numbers and statistics.
struct Stage {
  const char* name;
  double length;  ///< [ps]
  bool constant_pressure;
};

std::vector<Stage> stages_of(const Config& config) {
  const PreparationSettings& p = config.prepare;
  std::vector<Stage> stages = {{"NVT", p.nvt / 2, false}, {"NVT", p.nvt / 2, false}};
  if (config.ensemble.barostat)
    stages.insert(stages.end(), {{"NPT", p.npt / 2, true}, {"NPT", p.npt / 2, true}});
  std::erase_if(stages, [](const Stage& stage) { return stage.length < 2 * max_step; });
  if (stages.empty())
    throw Error(
        "the preparation has no dynamics, since nvt and npt are 0 ps; give one of them a length, "
        "or "
        "only minimise",
        config.source);
  return stages;
}

class Preparation {
 public:
  Preparation(const Config& config, const Callbacks& callbacks, Workers& workers)
      : config_(config), callbacks_(callbacks), workers_(workers), stages_(stages_of(config)) {}

  PreparationReport perform(const std::string& final_state, const std::string& run_file);

 private:
  TrajectorySettings settings_of(std::size_t stage) const;
  Trajectory run(System& system, std::size_t stage, const TrajectorySettings& settings) const;
  PreparedProperties properties(const System& system, const TrajectorySettings& settings,
                                const Trajectory& trajectory) const;
  void choose_density(PreparationReport& report);

  Config config_;
  const Callbacks& callbacks_;
  Workers& workers_;
  std::vector<Stage> stages_;
  double step_ = first_step;
};

void Preparation::choose_density(PreparationReport& report) {
  SystemSettings& s = config_.system;
  if (!s.initial_configuration.empty()) return;
  const Topology topology = build_topology(s);
  report.estimated = !s.density && !s.box && config_.ensemble.barostat;
  if (report.estimated) s.density = estimated_density(topology);
  if (s.box) report.lattice_density = topology.mass() / Box{*s.box}.volume();
  if (s.density) report.lattice_density = *s.density;
  if (report.estimated)
    callbacks_.note(fmt::format(
        "note: there is no density, so the lattice has {:.3g} g/cm3, estimated from the diameters "
        "of the sites; the barostat changes it",
        g_per_cm3(*s.density)));
}

TrajectorySettings Preparation::settings_of(std::size_t stage) const {
  TrajectorySettings settings{.scheme = scheme_of("baoab"),
                              .step = step_,
                              .length = stages_[stage].length,
                              .sample = 0.02,
                              .seed = derived_seed(config_.system.seed, streams + stage)};
  settings.ensemble.temperature = config_.system.temperature;
  settings.ensemble.thermostat =
      ThermostatSettings{.friction = friction, .rotational_friction = friction};
  if (stages_[stage].constant_pressure) settings.ensemble.barostat = config_.ensemble.barostat;
  return settings;
}

Trajectory Preparation::run(System& system, std::size_t stage,
                            const TrajectorySettings& settings) const {
  double all = 0, before = 0;
  for (std::size_t k = 0; k < stages_.size(); ++k) {
    if (k < stage) before += stages_[k].length;
    all += stages_[k].length;
  }
  const std::string name = stages_[stage].name;
  const Watch watch{.sample =
                        [&](std::size_t steps, const State& state, const Energies&) {
                          const double now = static_cast<double>(steps) * settings.step;
                          callbacks_.report({"preparing", (before + now) / all,
                                             fmt::format("{}, {:.3g} g/cm3", name,
                                                         g_per_cm3(system.topology.mass() /
                                                                   state.box.volume()))});
                        },
                    .stop = callbacks_.stop};
  ForceField forces(system.topology, system.forces, system.state.box, workers_);
  Trajectory trajectory = run_trajectory(system, forces, settings, watch, workers_);
  if (!trajectory.failure.empty())
    throw RunError(fmt::format(
        "the preparation blew up in its {} stage, after {:g} ps of {:g} ps: {}; use a lower "
        "density, or another initial configuration",
        name, before + static_cast<double>(trajectory.steps) * settings.step, all,
        trajectory.cause));
  return trajectory;
}

/// A volume that still changes by more than half a percent.
std::optional<Warning> density_warning(const Drift& slope, double length, double volume) {
  constexpr double min_change = 0.005, significance_level = 0.001;
  const double change = slope.rate.value * length / volume;
  if (slope.known != Known::yes || slope.p_value > significance_level ||
      std::abs(change) < min_change)
    return std::nullopt;
  return Warning{"density", change, min_change,
                 fmt::format("the volume is still {}: by {:.2g} % in the last {:g} ps",
                             change > 0 ? "growing" : "shrinking", 100 * std::abs(change), length),
                 "prepare longer: npt = \"500 ps\" in [prepare], or give a density"};
}

/// A mean pressure from which the density will still change by more than half a percent.
std::optional<Warning> pressure_warning(const SeriesEstimate& pressure, const BarostatSettings& b) {
  constexpr double min_change = 0.005, far = 3;
  const double bar = unit("bar", Dimension::pressure);
  const double bound = std::max(far * pressure.error, min_change / b.compressibility);
  if (pressure.known != Known::yes || std::abs(pressure.value - b.pressure) <= bound)
    return std::nullopt;
  return Warning{"barostat", pressure.value / bar, bound / bar,
                 fmt::format("the mean pressure is {:.3g} bar instead of {:g} bar: the volume has "
                             "not reached equilibrium",
                             pressure.value / bar, b.pressure / bar),
                 "prepare longer: npt = \"500 ps\" in [prepare], or give a density"};
}

PreparedProperties Preparation::properties(const System& system, const TrajectorySettings& settings,
                                           const Trajectory& trajectory) const {
  const EnergyStatistics& energies = trajectory.statistics.energies;
  PreparedProperties p{summary(system, settings, trajectory), energies.volume(), {}};
  const double mass = system.topology.mass(), V = p.density.value;
  if (settings.ensemble.barostat) p.pressure = settings.ensemble.barostat->pressure;
  p.density.value = mass / V;
  p.density.error *= mass / (V * V);
  p.warnings =
      warnings_of_results(p.summary, TargetTemperature{settings.ensemble.temperature, false});
  for (const auto& warning :
       {settings.ensemble.barostat ? density_warning(energies.volume_drift(), p.summary.length, V)
                                   : std::nullopt,
        settings.ensemble.barostat
            ? pressure_warning(p.summary.pressure, *settings.ensemble.barostat)
            : std::nullopt,
        cutoff_of_ions(system)})
    if (warning) p.warnings.push_back(*warning);
  return p;
}

/// A run at constant energy keeps the energy of its start, and with the mean of the canonical
/// distribution it has the temperature of the thermostat: momenta are scaled to it.
void set_energy(System& system, double mean_total, Workers& workers) {
  State& state = system.state;
  ForceField forces(system.topology, system.forces, state.box, workers);
  Load load;
  forces(state, load);
  const Energies now = energies(state, system.bodies, load, workers);
  const double kinetic = mean_total - now.potential();
  if (!(kinetic > 0) || !(now.kinetic() > 0)) return;
  const double factor = std::sqrt(kinetic / now.kinetic());
  for (std::size_t i = 0; i < state.size(); ++i) {
    state.p.set(i, factor * state.p[i]);
    state.ell.set(i, factor * state.ell[i]);
  }
}

PreparationReport Preparation::perform(const std::string& final_state,
                                       const std::string& run_file) {
  PreparationReport report;
  choose_density(report);
  config_.run.minimise = true;
  System system = build_system(config_);
  report.molecules = system.topology.size();
  note_molecules(system, callbacks_);
  note_forces(system, callbacks_);
  report.minimisation = minimise(system, bounds, watch_of(callbacks_), workers_);
  callbacks_.note(description(report.minimisation));
  if (report.minimisation.end == MinimisationEnd::stopped) return report;
  check_separated(system, report.minimisation);
  draw_momenta(system, config_.system.seed);
  for (std::size_t k = 0; k < stages_.size(); ++k) {
    const TrajectorySettings settings = settings_of(k);
    callbacks_.note(fmt::format("{} for {:g} ps in steps of {:g} fs", stages_[k].name,
                                stages_[k].length, step_ * units::fs_per_ps));
    const Trajectory trajectory = run(system, k, settings);
    if (trajectory.stopped) return report;
    if (k + 1 == stages_.size()) {
      report.properties = properties(system, settings, trajectory);
      if (!config_.ensemble.thermostat && !config_.ensemble.hybrid_monte_carlo)
        set_energy(system, trajectory.statistics.energies.total(), workers_);
    }
    // Forces are those of a liquid now.
    constexpr double tenth_of_fs = 1e-4;
    const double stable = max_stable_step(system, system.state, settings, workers_);
    step_ = std::clamp(std::floor(stable / tenth_of_fs) * tenth_of_fs, tenth_of_fs, max_step);
  }
  system.state.time = 0;
  write_file(final_state,
             [&](std::ostream& out) { write_gro(out, system.state, system.topology); });
  write_file(run_file,
             [&](std::ostream& out) { out << prepared_run_file(config_, final_state, run_file); });
  report.final_state = final_state;
  report.run_file = run_file;
  return report;
}

}  // namespace

PreparationReport prepare(const Config& config, const OutputOptions& options,
                          const Callbacks& callbacks, Workers& workers) {
  const std::string& prefix = config.output.prefix;
  check_prefix(prefix);
  const OutputLock lock(prefix + "-prepare.lock", callbacks);
  const std::string final_state = prefix + "-prepared.gro", run_file = prefix + "-prepared.toml";
  check_outputs({final_state, run_file}, options.existing);
  return Preparation(config, callbacks, workers).perform(final_state, run_file);
}

}  // namespace polhode
