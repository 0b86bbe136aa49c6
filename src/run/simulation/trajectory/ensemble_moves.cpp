// SPDX-License-Identifier: MIT
#include "run/simulation/trajectory/ensemble_moves.hpp"

#include <fmt/core.h>

#include "io/settings/ensemble_names.hpp"
#include "io/settings/output_units.hpp"
#include "io/settings/quantity.hpp"
#include "polhode/base/error.hpp"
#include "polhode/base/units.hpp"

namespace polhode {
namespace {

/// With the interval between moves as it is, in place of the one that was asked for.
BarostatSettings barostat_settings(const TrajectorySettings& settings) {
  BarostatSettings barostat = *settings.ensemble.barostat;
  barostat.every = settings.move_interval();
  return barostat;
}

void check_thermostat(const ThermostatSettings& s, double step) {
  if (s.kind == ThermostatKind::langevin) {
    for (const double rate : {s.friction, s.rotational_friction})
      if (const std::string wrong = wrong_friction(rate); !wrong.empty())
        throw Error(fmt::format("the thermostat's friction of {:g} 1/ps {}", rate, wrong));
  } else if (!(s.time_constant >= step)) {
    throw Error(fmt::format(
        "the thermostat's time_constant of {:g} fs is shorter than the step of {:g} fs; it must be "
        "at least a step, and 100 to 1000 fs are usual",
        s.time_constant * units::fs_per_ps, step * units::fs_per_ps));
  }
}

void check_barostat(const TrajectorySettings& settings) {
  const BarostatSettings& s = *settings.ensemble.barostat;
  if (!(s.every > 0))
    throw Error(fmt::format(
        "the interval of the moves of the barostat, {:g} fs, must be longer than 0 fs; 100 fs are "
        "usual",
        s.every * units::fs_per_ps));
  const double interval = settings.move_interval();
  if (s.kind == BarostatKind::cell_rescaling && !(s.time_constant >= interval))
    throw Error(fmt::format(
        "the barostat's time_constant of {:g} fs is shorter than the interval of its moves, {:g} "
        "fs{}; use a time_constant of 1 to 10 ps, or a shorter interval",
        s.time_constant * units::fs_per_ps, interval * units::fs_per_ps,
        settings.ensemble.hybrid_monte_carlo ? " of whole trajectories of hybrid Monte Carlo"
                                             : ""));
  if (!(s.compressibility >= min_compressibility() && s.compressibility <= max_compressibility()))
    throw Error(fmt::format(
        "the barostat's compressibility of {:g} 1/bar must be from 1e-7 1/bar, which solids have, "
        "to 10 1/bar, which a thin gas has; use default_compressibility() if it is not known, or "
        "that of the system",
        s.compressibility / unit("1/bar", Dimension::compressibility)));
}

}  // namespace

void check_ensemble(const TrajectorySettings& settings) {
  const EnsembleSettings& e = settings.ensemble;
  if (settings.scheme.has(Flow::bath) && !e.thermostat && !e.hybrid_monte_carlo)
    throw Error(
        "the scheme has a bath O, and a bath needs a thermostat; add a table [thermostat], or "
        "leave the stages O(...) out of the scheme");
  if (e.hybrid_monte_carlo) {
    if (e.thermostat)
      throw Error("hybrid Monte Carlo keeps the temperature itself; leave the thermostat out");
    check_hybrid(settings.scheme);
    if (settings.inner) check_hybrid(settings.inner->scheme);
  }
  if (e.barostat && !e.thermostat && !e.hybrid_monte_carlo)
    throw Error(
        "a barostat exchanges work with the bodies, so it needs a thermostat; add a table "
        "[thermostat], for example with type = \"rescaling\"");
  if ((e.barostat || e.hybrid_monte_carlo) && !(e.temperature > 0))
    throw Error(
        fmt::format("the temperature of {:g} K must be above 0 K for a barostat or hybrid "
                    "Monte Carlo, which accept moves by their energy in units of kT; use a "
                    "higher temperature, or a thermostat alone",
                    e.temperature));
  if (e.thermostat) check_thermostat(*e.thermostat, settings.step);
  if (e.barostat) check_barostat(settings);
}

EnsembleMoves::EnsembleMoves(const System& system, const TrajectorySettings& settings,
                             Workers& workers) {
  check_ensemble(settings);
  const EnsembleSettings& e = settings.ensemble;
  if (e.thermostat)
    thermostat_.emplace(*e.thermostat, e.temperature, system.topology, system.bodies, settings.seed,
                        workers);
  if (e.barostat) {
    barostat_.emplace(barostat_settings(settings), e.temperature, system.bodies, settings.seed);
    steps_per_move_ = settings.steps_per_move();
  }
  if (e.hybrid_monte_carlo)
    hybrid_.emplace(*e.hybrid_monte_carlo, e.temperature, system.bodies, settings.seed, workers);
}

void EnsembleMoves::Bath::operator()(State& state, double t, StageNumber at) const {
  moves->thermostat_.value()(state, t, at);
}

bool EnsembleMoves::after_step(State& state, std::size_t steps, Load& load,
                               const Barostat::Evaluate& evaluate) {
  bool changed = false;
  if (decides(steps)) changed = !hybrid_->end(state, load, steps);
  if (moves_box(steps)) changed = barostat_->move(state, load, evaluate, steps) || changed;
  return changed;
}

EnsembleMemory EnsembleMoves::memory() const {
  EnsembleMemory memory;
  if (thermostat_) memory.heat = thermostat_->heat();
  if (barostat_) memory.barostat = barostat_->memory();
  if (hybrid_) memory.hybrid = hybrid_->memory();
  return memory;
}

void EnsembleMoves::resume_from(const EnsembleMemory& memory) {
  if (thermostat_) thermostat_->resume_from(memory.heat);
  if (barostat_) barostat_->resume_from(memory.barostat);
  if (hybrid_) hybrid_->resume_from(memory.hybrid);
}

}  // namespace polhode
