// SPDX-License-Identifier: MIT
#include "polhode/run/simulation/propagator.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "clocks.hpp"
#include "polhode/base/error.hpp"
#include "polhode/forces/laws/law_range.hpp"
#include "polhode/forces/timed_forces.hpp"
#include "polhode/integrate/flows.hpp"
#include "polhode/integrate/nested_integrator.hpp"
#include "polhode/io/nested_scheme_text.hpp"
#include "polhode/io/output_units.hpp"
#include "polhode/run/simulation/contact.hpp"
#include "polhode/run/simulation/ensemble_moves.hpp"
#include "polhode/run/simulation/near_forces.hpp"
#include "polhode/run/simulation/stable_step.hpp"

namespace polhode {
namespace {

/// Ends the trajectory but keeps its results.
struct BlowUp : RunError {
  BlowUp(const std::string& what, std::string why) : RunError(what), cause(std::move(why)) {}
  std::string cause;
};

/// The share of the potential energy by which rounding in mixed precision may change the total
/// energy of a run that begins almost at rest.
constexpr double rounding_share = 1e-5;

/// What shows which molecules collided: its copy at each step costs half of that of the state.
void copy_positions(const State& from, State& to) {
  to.q = from.q;
  to.attitude = from.attitude;
  to.box = from.box;
}

/// @param shorter  step to try [ps]; nothing if no step is short enough
[[noreturn]] void throw_blow_up(const TrajectorySettings& s, std::size_t step,
                                const std::string& cause, std::optional<double> shorter) {
  const std::string remedy =
      shorter ? fmt::format(
                    "the step of {:g} fs is too long for {}, or the initial configuration "
                    "is too far from equilibrium: try {}, or equilibrate first",
                    s.step * units::fs_per_ps, name_of({s.scheme, s.inner}), rounded_fs(*shorter))
              : "molecules of the initial configuration overlap, which no step can help: use "
                "minimise = true and equilibrate in [run], or 'polhode prepare'";
  throw BlowUp(fmt::format("the run blew up at step {} ({:.4f} ps): {}; {}", step,
                           static_cast<double>(step) * s.step, cause, remedy),
               cause);
}

/// The integrator of a trajectory with its forces: of one scheme, or of two for multiple time
/// steps.
class TimedIntegrator {
 public:
  TimedIntegrator(System& system, ForceField& forces, const TrajectorySettings& settings,
                  EnsembleMoves::Bath bath, Workers& workers)
      : whole{forces} {
    if (!settings.inner) {
      single_.emplace(settings.scheme, system.bodies, whole, FreeDrift{system.bodies, workers},
                      bath, settings.lambda, workers);
      return;
    }
    near_forces_.emplace(system.topology, near_settings(forces.settings(), *settings.inner),
                         system.state.box, workers);
    near.emplace(TimedForces{*near_forces_});
    nested_.emplace(NestedScheme{settings.scheme, settings.inner}, system.bodies, whole, *near,
                    settings.lambda, workers, bath);
  }
  TimedIntegrator(const TimedIntegrator&) = delete;
  TimedIntegrator& operator=(const TimedIntegrator&) = delete;

  /// Calls f with the integrator.
  template <class F>
  decltype(auto) apply(const F& f) {
    return single_ ? f(*single_) : f(*nested_);
  }

  void resume_from(const RunState& state) {
    apply([&](auto& integrator) { integrator.resume_from(state.integrator); });
    whole.forces.resume_from(state.list, state.state.box);
    if (near) near->forces.resume_from(state.near_list, state.state.box);
  }

  void count(Trajectory& trajectory) {
    apply([&](const auto& integrator) {
      trajectory.force_evaluations = integrator.force_evaluations();
      trajectory.derivatives = integrator.derivatives();
      trajectory.measurements = integrator.measurements();
    });
    trajectory.list_rebuilds = whole.forces.list_rebuilds();
    if (!nested_) return;
    trajectory.near_evaluations = nested_->near_evaluations();
    trajectory.near_derivatives = nested_->near_derivatives();
  }

  TimedForces whole;
  std::optional<TimedForces> near;  // of an inner scheme

 private:
  std::optional<Integrator<TimedForces, FreeDrift, EnsembleMoves::Bath>> single_;
  std::optional<ForceField> near_forces_;
  std::optional<NestedIntegrator<TimedForces, TimedForces, EnsembleMoves::Bath>> nested_;
};

}  // namespace

class Propagator::Impl {
 public:
  Impl(System& system, ForceField& forces, const TrajectorySettings& settings, Workers& workers)
      : system_(system),
        settings_(settings),
        workers_(workers),
        terms_(error_terms(settings.scheme)),
        fixed_(settings.fixed_means()),
        ideal_(static_cast<double>(system.state.size()) * units::boltzmann *
               settings.ensemble.temperature),
        interval_(settings.steps_per_sample()),
        moves_(system, settings, workers),
        integrator_(system, forces, settings, moves_.bath(), workers),
        start_(system.state.time) {
    copy_positions(system.state, first_);
    start_clocks({});
  }

  std::size_t steps() const { return steps_; }
  const Segment& segment() const { return segment_; }
  double exchanged() const { return moves_.exchanged(); }

  void resume_from(const RunState& from) {
    system_.state = from.state;
    start_ = from.start;
    steps_ = from.steps;
    segment_ = from.segment;
    conserved_.reset();
    potential_.reset();
    before_last_sample_.reset();
    statistics_ = from.statistics;
    integrator_.resume_from(from);
    moves_.resume_from(from.ensemble);
    start_clocks(from.timings);
  }

  RunState run_state() {
    if (before_last_sample_) return *before_last_sample_;
    clocks_->add_motion();
    RunState now{
        system_.state,
        std::nullopt,
        steps_,
        start_,
        integrator_.apply([](const auto& integrator) { return integrator.memory(); }),
        integrator_.whole.forces.list_memory(system_.state.box),
        integrator_.near ? integrator_.near->forces.list_memory(system_.state.box) : ListMemory{},
        statistics_,
        clocks_->timings(),
        moves_.memory(),
        segment_};
    clocks_->skip();
    return now;
  }

  void advance(std::size_t steps, const Watch& watch) {
    const std::size_t whole = settings_.steps_per_trajectory();
    if (steps % whole != 0)
      throw Error(fmt::format(
          "{} steps are not whole trajectories of hybrid Monte Carlo, which have {} steps each; "
          "advance by a multiple of them",
          steps, whole));
    leave_last_sample();
    clocks_->skip_pause();
    if (statistics_.energies.samples == 0) sample(watch);
    bool stopped = false;
    for (std::size_t k = 0; k < steps && !stopped; ++k) {
      sampled_step(watch);
      stopped = watch.stop && (k + 1) % whole == 0 && watch.stop();
    }
    clocks_->add_motion();
    clocks_->timings();
  }

  Trajectory run(const Watch& watch) {
    leave_last_sample();
    const std::size_t last = last_step(settings_, segment_);
    bool stopped = false;
    std::string failure, cause;
    try {
      if (statistics_.energies.samples == 0) {
        checkpoint(watch);
        sample(watch);
      }
      while (steps_ < last && !stopped) {  // one by one, so that a failed step is identified
        for (std::size_t k = 0; k < settings_.steps_per_trajectory(); ++k) sampled_step(watch);
        stopped = watch.stop && watch.stop();
        if (stopped || steps_ == last || (watch.due && watch.due())) checkpoint(watch);
      }
      if (!sampled(steps_)) last_sample(watch);
    } catch (const BlowUp& e) {
      failure = e.what();
      cause = e.cause;
    }
    clocks_->add_motion();
    Trajectory result = trajectory();
    result.stopped = stopped;
    result.failure = std::move(failure);
    result.cause = std::move(cause);
    return result;
  }

  Trajectory trajectory() {
    Trajectory result;
    result.statistics = statistics_;
    result.steps = steps_;
    result.segment = segment_;
    integrator_.count(result);
    result.timings = clocks_->timings();
    result.ensemble = moves_.memory();
    return result;
  }

 private:
  void start_clocks(const Timings& earlier) {
    clocks_.emplace(integrator_.whole, integrator_.near ? &*integrator_.near : nullptr, earlier);
  }

  void checkpoint(const Watch& watch) {
    if (watch.checkpoint) watch.checkpoint(run_state());
  }

  void sampled_step(const Watch& watch) {
    const bool samples = sampled(steps_ + 1), moves = moves_.due(steps_ + 1);
    moves_.before_step(system_.state, steps_, [&]() -> const Load& { return complete_load(); });
    step(samples || moves);
    if (moves) move();
    if (samples) sample(watch);
  }

  std::size_t steps_of_segment() const { return steps_ - segment_.first_step; }

  /// Samples are counted from the beginning of the segment, which has the first one.
  bool sampled(std::size_t step) const { return (step - segment_.first_step) % interval_ == 0; }

  /// Of the current positions, with energies.
  const Load& complete_load() {
    return integrator_.apply(
        [&](auto& integrator) -> const Load& { return integrator.load(system_.state); });
  }

  /// What thermostat, barostat and hybrid Monte Carlo do between steps.
  void move() try {
    moved_ = complete_load();
    const bool changed =
        moves_.after_step(system_.state, steps_, moved_,
                          [&](const State& state, Load& load) { integrator_.whole(state, load); });
    if (changed) integrator_.apply([&](auto& integrator) { integrator.replace_load(moved_); });
  } catch (const Error& e) {
    throw RunError(
        fmt::format("at step {} ({:.4f} ps) the barostat moved the box, and: {}; use a larger "
                    "system, a shorter cutoff, {}or check the pressure",
                    steps_, system_.state.time, e.what(),
                    settings_.ensemble.barostat->edges.size() > 1
                        ? "edges = [\"xyz\"] in [barostat] for a fluid, "
                        : ""));
  }

  void step(bool energies) {
    copy_positions(system_.state, before_);
    try {
      integrator_.apply([&](auto& integrator) {
        integrator.advance(system_.state, settings_.step, 1, energies);
      });
    } catch (const RunError& e) {
      blow_up(steps_ + 1, e.what() + inner_limit_note(system_.topology));
    }
    ++steps_;
    system_.state.time = start_ + static_cast<double>(steps_of_segment()) * settings_.step;
    if (!std::isfinite(last_load().potential()))
      blow_up(steps_, "the potential energy is no longer a finite number" +
                          inner_limit_note(system_.topology));
  }

  /// @param step  that failed; the molecules that collided are those of the current state, or of
  /// the one before
  [[noreturn]] void blow_up(std::size_t step, std::string cause) const {
    std::string contact = strongest_contact(system_, system_.state);
    if (contact.empty()) contact = strongest_contact(system_, before_);
    if (!contact.empty()) cause += "; " + contact;
    throw_blow_up(settings_, step, cause, shorter_step(system_, first_, settings_, workers_));
  }

  const Load& last_load() {
    return integrator_.apply(
        [](const auto& integrator) -> const Load& { return integrator.last_load(); });
  }

  /// Forces and torques of the last kick; with an inner scheme, the outer one has the slow forces.
  const Load& all_forces() {
    if (!integrator_.near) return last_load();
    integrator_.whole.forces.forces_alone(system_.state, complete_);
    return complete_;
  }

  /// At the end, possibly between two samples: a longer trajectory would not have this one.
  void last_sample(const Watch& watch) {
    before_last_sample_ = run_state();
    sample(watch);
  }
  void leave_last_sample() {
    if (before_last_sample_) resume_from(*std::exchange(before_last_sample_, std::nullopt));
  }

  void sample(const Watch& watch) {
    clocks_->add_motion();
    Energies now = energies_now();
    sample_shadow(now, watch);
    if (watch.sample) watch.sample(steps_, system_.state, now);
    const std::optional<StepError> error = error_of(now);
    if (error) statistics_.step_bias.add(*error, now);
    sample_configurational(error);
    statistics_.energies.add(now);
    sample_at_bath();
    if (settings_.stretch > 0)
      statistics_.stretches.add(now, statistics_.energies.first,
                                settings_.samples_per(settings_.stretch));
    check_total(now);
    clocks_->skip();
  }

  Energies energies_now() try {
    const double before = clocks_->in_forces();
    Energies now = energies_of(system_, system_.state, complete_load(), workers_);
    now.exchanged = moves_.exchanged();
    clocks_->forces_of_sample(clocks_->in_forces() - before);
    if (!std::isfinite(now.total()))
      blow_up(steps_,
              "the total energy is no longer a finite number" + inner_limit_note(system_.topology));
    return now;
  } catch (const BlowUp&) {
    throw;
  } catch (const RunError& e) {
    blow_up(steps_, e.what() + inner_limit_note(system_.topology));
  }

  /// Whether this sample is one of those that are taken every `every` [ps]; 0: never.
  bool due(double every) const {
    return every > 0 && statistics_.energies.samples % settings_.samples_per(every) == 0;
  }

  /// The kinetic energies of the momenta on which a bath within the steps acts: those of full steps
  /// lack a kick.
  void sample_at_bath() {
    const double kick_after = settings_.scheme.kick_after_bath();
    if (kick_after == 0 || settings_.inner) return;
    State half = system_.state;
    kick(half, system_.bodies, last_load(), -kick_after * settings_.step, workers_);
    statistics_.at_bath.add(energies_of(system_, half, last_load(), workers_));
  }

  /// Nothing where it is not known.
  std::optional<StepError> error_of(const Energies& now) const {
    if (!fixed_) return std::nullopt;
    const StepError error = step_error(now, *fixed_, ideal_);
    return std::isnan(error.error) ? std::nullopt : std::optional(error);
  }

  void sample_configurational(const std::optional<StepError>& error) {
    if (!due(settings_.configurational_sample)) return;
    constexpr std::uint64_t streams = std::uint64_t{1}
                                      << 32;  // initial configurations use those below it
    statistics_.configurational.add(
        configurational_sample(system_.state, system_.bodies, all_forces(),
                               integrator_.whole.forces, Random(settings_.seed, streams + steps_)),
        error);
  }

  void sample_shadow(Energies& now, const Watch& watch) {
    if (!due(settings_.shadow_sample)) return;
    const BracketSample both{
        now, error_brackets(system_.state, system_.bodies, last_load(), integrator_.whole.forces)};
    const double shadow = shadow_energy(both, terms_, settings_.step);
    now.step_error = shadow - now.total();
    if (fixed_ != FixedMeans::energy) return;
    statistics_.shadow.add(now.time, shadow);
    if (watch.brackets) watch.brackets(both);
  }

  /// At constant energy since the start; a bath takes up a drift, so with one since the last
  /// sample. Errors count against the initial kinetic energy; almost at rest, against
  /// what the potential energy has set free. Hybrid Monte Carlo rejects such trajectories.
  void check_total(const Energies& now) {
    const Energies& first = statistics_.energies.first;
    const bool constant_energy = settings_.ensemble.constant_energy();
    const double from = constant_energy ? first.conserved() : conserved_.value_or(now.conserved());
    const double before =
        constant_energy ? first.potential() : potential_.value_or(now.potential());
    conserved_ = now.conserved();
    potential_ = now.potential();
    const double freed = std::abs(now.potential() - before);
    const double bound =
        std::max({first.kinetic(), freed, rounding_share * std::abs(first.potential())});
    if (settings_.ensemble.hybrid_monte_carlo || first.kinetic() == 0 ||
        !(std::abs(now.conserved() - from) > bound))
      return;
    blow_up(steps_,
            fmt::format("the {} energy went from {:.6g} to {:.6g} kJ/mol{}, more than the initial "
                        "kinetic energy",
                        constant_energy ? "total" : "conserved", from, now.conserved(),
                        constant_energy ? "" : " between two samples"));
  }

  System& system_;
  TrajectorySettings settings_;
  Workers& workers_;
  ErrorTerms terms_;
  std::optional<FixedMeans> fixed_;
  double ideal_;          // N kT [kJ/mol]
  std::size_t interval_;  // steps between samples
  EnsembleMoves moves_;
  TimedIntegrator integrator_;
  Load moved_;     // after a move of the box or a decision
  Load complete_;  // of all forces, where the integrator has the slow ones
  double start_;   // time of the state at the first step of the segment [ps]
  std::size_t steps_ = 0;
  Segment segment_;
  TrajectoryStatistics statistics_;
  std::optional<double> conserved_;  // energy at the last sample, unless that was before a resume
  std::optional<double> potential_;  // likewise
  std::optional<Clocks> clocks_;
  std::optional<RunState> before_last_sample_;
  State first_, before_;  // positions at the start, and before the last step
};

Propagator::Propagator(System& system, ForceField& forces, const TrajectorySettings& settings,
                       Workers& workers)
    : impl_(std::make_unique<Impl>(system, forces, settings, workers)) {}

Propagator::~Propagator() = default;

void Propagator::resume_from(const RunState& state) { impl_->resume_from(state); }

RunState Propagator::run_state() { return impl_->run_state(); }

void Propagator::advance(std::size_t steps, const Watch& watch) { impl_->advance(steps, watch); }

Trajectory Propagator::run(const Watch& watch) { return impl_->run(watch); }

double Propagator::exchanged() const { return impl_->exchanged(); }

std::size_t Propagator::steps() const { return impl_->steps(); }

const Segment& Propagator::segment() const { return impl_->segment(); }

Trajectory Propagator::trajectory() { return impl_->trajectory(); }

}  // namespace polhode
