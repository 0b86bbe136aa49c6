// SPDX-License-Identifier: MIT
#include "polhode/run/simulation/trajectory/propagator.hpp"

#include <fmt/core.h>

#include <cmath>
#include <optional>
#include <utility>

#include "blow_up.hpp"
#include "polhode/base/error.hpp"
#include "run/simulation/trajectory/ensemble_moves.hpp"
#include "sampler.hpp"
#include "timed_integrator.hpp"

namespace polhode {
class Propagator::Impl {
 public:
  Impl(System& system, ForceField& forces, const TrajectorySettings& settings, Workers& workers)
      : system_(system),
        settings_(settings),
        interval_(settings.steps_per_sample()),
        moves_(system, settings, workers),
        integrator_(system, forces, settings, moves_.bath(), workers),
        report_(system, settings_, workers),
        sampler_(system, settings_, integrator_, report_, workers),
        start_(system.state.time) {
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
    before_last_sample_.reset();
    sampler_.resume_from(from.statistics);
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
        integrator_.memory(),
        integrator_.whole.forces.list_memory(system_.state.box),
        integrator_.near ? integrator_.near->forces.list_memory(system_.state.box) : ListMemory{},
        sampler_.statistics(),
        clocks_->timings(),
        moves_.memory(),
        segment_};
    clocks_->skip();
    return now;
  }

  void advance(std::size_t steps, const Watch& watch) {
    const std::size_t whole = settings_.steps_per_trajectory();
    if (steps % whole != 0)
      throw Error(
          fmt::format("{} steps are not a whole number of hybrid Monte Carlo trajectories of {} "
                      "steps each; advance by a multiple of this number",
                      steps, whole));
    leave_last_sample();
    clocks_->skip_pause();
    if (sampler_.empty()) sample(watch);
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
      if (sampler_.empty()) {
        checkpoint(watch);
        sample(watch);
      }
      while (steps_ < last &&
             !stopped) {  // steps are taken individually, so that a failed step is identified
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
    result.statistics = sampler_.statistics();
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
    moves_.before_step(system_.state, steps_,
                       [&]() -> const Load& { return integrator_.load(system_.state); });
    step(samples || moves);
    if (moves) move();
    if (samples) sample(watch);
  }

  std::size_t steps_of_segment() const { return steps_ - segment_.first_step; }

  /// Whether a sample is taken after a step; the first sample is at the beginning of the segment.
  bool sampled(std::size_t step) const { return (step - segment_.first_step) % interval_ == 0; }

  /// Applies thermostat, barostat and hybrid Monte Carlo between steps.
  void move() try {
    moved_ = integrator_.load(system_.state);
    const bool changed =
        moves_.after_step(system_.state, steps_, moved_,
                          [&](const State& state, Load& load) { integrator_.whole(state, load); });
    if (changed) integrator_.apply([&](auto& integrator) { integrator.replace_load(moved_); });
  } catch (const Error& e) {
    throw RunError(
        fmt::format("at step {} ({:.4f} ps) the barostat moved the box, and the run cannot "
                    "continue: {}; use a larger "
                    "system, a shorter cutoff, {}or check the pressure",
                    steps_, system_.state.time, e.what(),
                    settings_.ensemble.barostat->edges.size() > 1
                        ? "edges = [\"xyz\"] in [barostat] for a fluid, "
                        : ""));
  }

  void step(bool energies) {
    report_.before_step();
    try {
      integrator_.apply([&](auto& integrator) {
        integrator.advance(system_.state, settings_.step, 1, energies);
      });
    } catch (const RunError& e) {
      report_.not_finite(steps_ + 1, e.what());
    }
    ++steps_;
    system_.state.time = start_ + static_cast<double>(steps_of_segment()) * settings_.step;
    if (!std::isfinite(integrator_.last_load().potential()))
      report_.not_finite(steps_, "the potential energy is no longer a finite number");
  }

  /// Takes a sample at the end of the trajectory, possibly between two regular samples. A longer
  /// trajectory would not have this last sample.
  void last_sample(const Watch& watch) {
    before_last_sample_ = run_state();
    sample(watch);
  }
  void leave_last_sample() {
    if (before_last_sample_) resume_from(*std::exchange(before_last_sample_, std::nullopt));
  }

  void sample(const Watch& watch) { sampler_.sample(steps_, moves_.exchanged(), *clocks_, watch); }

  System& system_;
  TrajectorySettings settings_;
  std::size_t interval_;  // number of steps between samples
  EnsembleMoves moves_;
  TimedIntegrator integrator_;
  BlowUpReport report_;
  Sampler sampler_;
  Load moved_;    // load after a barostat move or a decision
  double start_;  // time of the state at the first step of the segment [ps]
  std::size_t steps_ = 0;
  Segment segment_;
  std::optional<Clocks> clocks_;
  std::optional<RunState> before_last_sample_;
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
