// SPDX-License-Identifier: MIT
#include "sampler.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "polhode/integrate/flows.hpp"

namespace polhode {
namespace {

/// The allowed change of the total energy by mixed-precision round-off, as a fraction of the
/// potential energy, for a run that begins with almost no kinetic energy.
constexpr double rounding_share = 1e-5;

}  // namespace

Sampler::Sampler(const System& system, const TrajectorySettings& settings,
                 TimedIntegrator& integrator, const BlowUpReport& report, Workers& workers)
    : system_(system),
      settings_(settings),
      integrator_(integrator),
      report_(report),
      workers_(workers),
      terms_(settings.error_terms()),
      fixed_(settings.fixed_means()),
      ideal_(static_cast<double>(system.state.size()) * units::boltzmann *
             settings.ensemble.temperature) {}

void Sampler::resume_from(const TrajectoryStatistics& statistics) {
  statistics_ = statistics;
  conserved_.reset();
  potential_.reset();
}

void Sampler::sample(std::size_t step, double exchanged, Clocks& clocks, const Watch& watch) {
  clocks.add_motion();
  Reading reading = read(step, exchanged, clocks);
  sample_shadow(reading, watch);
  const Energies& now = reading.energies;
  if (watch.load) watch.load(reading.state, reading.load);
  if (watch.sample) watch.sample(step, reading.state, now);
  const std::optional<StepError> error = error_of(now);
  if (error) statistics_.step_bias.add(*error, now);
  sample_configurational(step, reading, error);
  statistics_.energies.add(now);
  sample_at_bath();
  if (settings_.stretch > 0)
    statistics_.stretches.add(now, statistics_.energies.first,
                              settings_.samples_per(settings_.stretch));
  check_energy(step, now);
  clocks.skip();
}

Sampler::Reading Sampler::read(std::size_t step, double exchanged, Clocks& clocks) try {
  const double before = clocks.in_forces();
  if (settings_.processed) processed_ = system_.state;
  const State& state = settings_.processed ? processed_ : system_.state;
  const Load& load =
      settings_.processed ? integrator_.process(processed_) : integrator_.load(system_.state);
  Reading now{state, load, energies_of(system_, state, load, workers_)};
  now.energies.exchanged = exchanged;
  clocks.forces_of_sample(clocks.in_forces() - before);
  if (!std::isfinite(now.energies.total()))
    report_.not_finite(step, "the total energy is no longer a finite number");
  return now;
} catch (const BlowUp&) {
  throw;
} catch (const RunError& e) {
  report_.not_finite(step, e.what());
}

/// Whether a quantity with the sampling interval `every` [ps] is due at this sample; never if
/// `every` is 0.
bool Sampler::due(double every) const {
  return every > 0 && statistics_.energies.samples % settings_.samples_per(every) == 0;
}

void Sampler::sample_shadow(Reading& now, const Watch& watch) {
  if (!due(settings_.shadow_sample)) return;
  const BracketSample both{
      now.energies, error_brackets(now.state, system_.bodies, now.load, integrator_.whole.forces)};
  const double shadow = shadow_energy(both, terms_, settings_.step);
  now.energies.step_error = shadow - now.energies.total();
  if (fixed_ != FixedMeans::energy) return;
  statistics_.shadow.add(now.energies.time, shadow);
  if (watch.brackets) watch.brackets(both);
}

/// The time-step error of a sample; empty if it is not known.
std::optional<StepError> Sampler::error_of(const Energies& now) const {
  if (!fixed_) return std::nullopt;
  const StepError error = step_error(now, *fixed_, ideal_);
  return std::isnan(error.error) ? std::nullopt : std::optional(error);
}

void Sampler::sample_configurational(std::size_t step, const Reading& now,
                                     const std::optional<StepError>& error) {
  if (!due(settings_.configurational_sample)) return;
  constexpr std::uint64_t streams = std::uint64_t{1}
                                    << 32;  // initial configurations use smaller numbers
  statistics_.configurational.add(
      configurational_sample(now.state, system_.bodies,
                             integrator_.near ? integrator_.all_forces(now.state) : now.load,
                             integrator_.whole.forces, Random(settings_.seed, streams + step)),
      error);
}

/// Samples the kinetic energies of the momenta on which a bath within the steps acts. The momenta
/// at full steps differ by a kick from the momenta on which the bath acts.
void Sampler::sample_at_bath() {
  const double kick_after = settings_.scheme.kick_after_bath();
  if (kick_after == 0 || settings_.inner) return;
  State half = system_.state;
  kick(half, system_.bodies, integrator_.last_load(), -kick_after * settings_.step, workers_);
  statistics_.at_bath.add(energies_of(system_, half, integrator_.last_load(), workers_));
}

/// Checks that the energy has not changed by more than is physically possible. At constant energy,
/// the change is measured since the start. With a bath, the change is measured since the last
/// sample, because the bath absorbs a slow energy drift. The change is compared with the initial
/// kinetic energy or, if this energy is almost zero, with the released potential energy. Hybrid
/// Monte Carlo needs no check, because it rejects trajectories with a large change of the energy.
void Sampler::check_energy(std::size_t step, const Energies& now) {
  const Energies& first = statistics_.energies.first;
  const bool constant_energy = settings_.ensemble.constant_energy();
  const double from = constant_energy ? first.conserved() : conserved_.value_or(now.conserved());
  const double before = constant_energy ? first.potential() : potential_.value_or(now.potential());
  conserved_ = now.conserved();
  potential_ = now.potential();
  const double freed = std::abs(now.potential() - before);
  const double bound =
      std::max({first.kinetic(), freed, rounding_share * std::abs(first.potential())});
  if (settings_.ensemble.hybrid_monte_carlo || first.kinetic() == 0 ||
      !(std::abs(now.conserved() - from) > bound))
    return;
  report_.blow_up(step, fmt::format("the {} energy changed from {:.6g} to {:.6g} kJ/mol{}, by more "
                                    "than the initial kinetic energy",
                                    constant_energy ? "total" : "conserved", from, now.conserved(),
                                    constant_energy ? "" : " between two samples"));
}

}  // namespace polhode
