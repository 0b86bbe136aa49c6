// SPDX-License-Identifier: MIT
#include "run/simulation/trajectory/ensemble_moves.hpp"

#include <fmt/core.h>

#include "io/settings/ensemble_text.hpp"
#include "io/settings/output_units.hpp"
#include "polhode/base/error.hpp"

namespace polhode {
namespace {

/// The barostat settings with the actual interval between moves instead of the requested interval.
BarostatSettings barostat_settings(const TrajectorySettings& settings) {
  BarostatSettings barostat = *settings.ensemble.barostat;
  barostat.every = settings.move_interval();
  return barostat;
}

/// Throws an Error if a thermostat or barostat has a time constant shorter than a step.
template <class Type>
void check_time_constant(const Type& type, double step) {
  if constexpr (requires { type.time_constant; })
    if (!(type.time_constant >= step))
      throw Error(
          fmt::format("the thermostat's time_constant of {:g} fs is shorter than the step of {:g} "
                      "fs; it must be at least one step, and 100 to 1000 fs are usual",
                      type.time_constant * units::fs_per_ps, step * units::fs_per_ps));
}

void check_barostat(const TrajectorySettings& settings) {
  const auto* const rescaling = std::get_if<CellRescaling>(&settings.ensemble.barostat->type);
  const double interval = settings.move_interval();
  if (rescaling && !(rescaling->time_constant >= interval))
    throw Error(fmt::format(
        "the barostat's time_constant of {:g} fs is shorter than the interval of its moves, {:g} "
        "fs{}; use a time_constant of 1 to 10 ps, or a shorter interval",
        rescaling->time_constant * units::fs_per_ps, interval * units::fs_per_ps,
        settings.ensemble.hybrid_monte_carlo ? " (whole trajectories of hybrid Monte Carlo)" : ""));
}

}  // namespace

void check_ensemble(const TrajectorySettings& settings) {
  const EnsembleSettings& e = settings.ensemble;
  if (settings.scheme.has(Flow::bath) && !e.thermostat && !e.hybrid_monte_carlo)
    throw Error(
        "the scheme has a bath O, but a bath needs a thermostat; add a table [thermostat], or "
        "leave the stages O(...) out of the scheme");
  if (e.thermostat && !settings.scheme.has(Flow::bath) && !e.hybrid_monte_carlo)
    throw Error(
        "the thermostat acts in a bath O, but the scheme has no bath; add a bath with with_bath(), "
        "or leave the thermostat out");
  if (e.hybrid_monte_carlo) {
    if (e.thermostat)
      throw Error(
          "hybrid Monte Carlo controls the temperature without a thermostat; leave the thermostat "
          "out");
    check_hybrid(settings.scheme);
    if (settings.inner) check_hybrid(settings.inner->scheme);
  }
  if (e.barostat && !e.thermostat && !e.hybrid_monte_carlo)
    throw Error(
        "a barostat exchanges work with the bodies, so it needs a thermostat; add a table "
        "[thermostat], for example with type = \"rescaling\"");
  if ((e.barostat || e.hybrid_monte_carlo) && !(e.temperature > 0))
    throw Error(fmt::format(
        "the temperature of {:g} K must be above 0 K for a barostat or hybrid Monte Carlo, since "
        "both compare energies with kT; use a higher temperature, or only a thermostat",
        e.temperature));
  if (const std::string wrong = wrong_setting(e); !wrong.empty()) throw Error(wrong);
  if (e.thermostat)
    std::visit([&](const auto& type) { check_time_constant(type, settings.step); }, *e.thermostat);
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
