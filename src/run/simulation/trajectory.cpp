// SPDX-License-Identifier: MIT
#include "polhode/run/simulation/trajectory.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "polhode/base/error.hpp"
#include "polhode/forces/laws/law_range.hpp"
#include "polhode/integrate/nested_integrator.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/io/nested_scheme_text.hpp"
#include "polhode/io/output_units.hpp"
#include "polhode/run/simulation/near_forces.hpp"

namespace polhode {
namespace {

class Stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Forces with a stopwatch.
struct TimedForces {
  ForceField& forces;
  double seconds = 0;  // with the list
  void operator()(const State& state, Load& load) {
    Stopwatch watch;
    forces(state, load);
    seconds += watch.lap();
  }
  void forces_alone(const State& state, Load& load) {
    Stopwatch watch;
    forces.forces_alone(state, load);
    seconds += watch.lap();
  }
  void directional_derivative(const State& state, const Vec3Column& dq, const Vec3Column& dtheta,
                              Load& slope) {
    Stopwatch watch;
    forces.directional_derivative(state, dq, dtheta, slope);
    seconds += watch.lap();
  }
};

constexpr double max_steps = 0x1p53;  // whose steps a double can count

/// Ends the trajectory but keeps its results.
struct BlowUp : RunError {
  using RunError::RunError;
};

[[noreturn]] void throw_blow_up(const TrajectorySettings& s, std::size_t step,
                                const std::string& what) {
  throw BlowUp(fmt::format(
      "the run blew up at step {} ({:.4f} ps): {}; the step of {:g} fs is too long for {}, or the "
      "initial configuration is too far from equilibrium: try {:g} fs, or equilibrate first",
      step, static_cast<double>(step) * s.step, what, s.step * units::fs_per_ps,
      name_of({s.scheme, s.inner}), s.step * 500));
}

/// Computing time by part, added to that of an earlier part of the run.
class Clocks {
 public:
  /// @param near  of an inner scheme, if there is one
  Clocks(const TimedForces& whole, const TimedForces* near, const Timings& earlier)
      : whole_(whole),
        near_(near),
        earlier_(earlier),
        list_before_(in_list(&whole)),
        near_list_before_(in_list(near)) {}
  double in_forces() const { return whole_.seconds + (near_ ? near_->seconds : 0); }
  /// The time since the last call of this or skip() was spent in drifts, kicks and forces.
  void add_motion() { motion_ += part_.lap(); }
  void skip() { part_.lap(); }
  void forces_of_sample(double seconds) { forces_of_samples_ += seconds; }
  Timings timings() {
    all_ += run_.lap();
    const double list = in_list(&whole_) - list_before_;
    const double near_list = in_list(near_) - near_list_before_;
    const double motion = motion_ - (in_forces() - forces_of_samples_);
    return {earlier_.forces + whole_.seconds - list, earlier_.list + list + near_list,
            earlier_.motion + motion,
            earlier_.measurement + std::max(0.0, all_ - in_forces() - motion),
            earlier_.near + (near_ ? near_->seconds : 0) - near_list};
  }

 private:
  static double in_list(const TimedForces* timed) {
    return timed ? timed->forces.neighbours().seconds() : 0;
  }

  const TimedForces& whole_;
  const TimedForces* near_;
  Timings earlier_;
  double list_before_, near_list_before_;
  double all_ = 0, motion_ = 0;
  double forces_of_samples_ = 0;  // schemes that end with a drift need forces for the energy
  Stopwatch run_, part_;
};

/// The trajectory of an Integrator or a NestedIntegrator.
/// @param whole, near  its forces; near is null without an inner scheme
template <class AnyIntegrator>
Trajectory integrate(System& system, AnyIntegrator& integrator, TimedForces& whole,
                     TimedForces* near, const TrajectorySettings& settings, const Watch& watch,
                     Workers& workers, const RunState* from);

}  // namespace

std::size_t TrajectorySettings::steps() const {
  if (!(length / step <= max_steps))
    throw Error(
        fmt::format("{:g} ps in steps of {:g} fs are {:.3g} steps; the maximum is {:.3g}, beyond "
                    "which the times of steps could not be distinguished; take a shorter length",
                    length, step * units::fs_per_ps, length / step, max_steps));
  return static_cast<std::size_t>(std::llround(length / step));
}

std::size_t TrajectorySettings::steps_per_sample() const {
  const double every = std::min(sample / step * (1 + 1e-12), max_steps);
  return std::max<std::size_t>(1, static_cast<std::size_t>(every));
}

std::size_t TrajectorySettings::samples_per(double interval) const {
  const double samples = interval / (static_cast<double>(steps_per_sample()) * step) * (1 + 1e-12);
  return std::max<std::size_t>(1, static_cast<std::size_t>(std::min(samples, max_steps)));
}

bool TrajectorySettings::has_shadow() const {
  constexpr double rounding = 1e-12;  // of coefficients with 15 digits
  const ErrorTerms terms = error_terms(scheme);
  return !inner && !scheme.has(Flow::bath) && scheme.palindromic() &&
         std::hypot(terms.alpha, terms.beta) > rounding;
}

void TrajectorySettings::check_shadow() const {
  if (shadow_sample == 0 || has_shadow()) return;
  if (inner)
    throw Error(fmt::format(
        "shadow_sample is {:g} fs, but the shadow energy of {} has error brackets of near and slow "
        "forces, which are not measured; leave it out, or take a single scheme, such as hoa2",
        shadow_sample * units::fs_per_ps, name_of({scheme, inner})));
  const char* const reason =
      scheme.has(Flow::bath) ? "a bath, which changes the energy"
      : scheme.palindromic()
          ? "no error of order h², so its shadow energy is the energy itself to that order"
          : "an error of order h, since its stages are not a palindrome";
  throw Error(fmt::format(
      "shadow_sample is {:g} fs, but {} has {}; leave it out, or take a palindrome of order 2, "
      "such as hoa2",
      shadow_sample * units::fs_per_ps, scheme.name(), reason));
}

Trajectory run_trajectory(System& system, ForceField& forces, const TrajectorySettings& settings,
                          const Watch& watch, Workers& workers, const RunState* from) {
  TimedForces whole{forces};
  if (!settings.inner) {
    Integrator integrator(settings.scheme, system.bodies, whole, settings.lambda, workers);
    return integrate(system, integrator, whole, nullptr, settings, watch, workers, from);
  }
  ForceField near_forces(system.topology, near_settings(forces.settings(), *settings.inner),
                         system.state.box, workers);
  TimedForces near{near_forces};
  NestedIntegrator integrator({settings.scheme, settings.inner}, system.bodies, whole, near,
                              settings.lambda, workers);
  Trajectory result = integrate(system, integrator, whole, &near, settings, watch, workers, from);
  result.near_evaluations = integrator.near_evaluations();
  result.near_derivatives = integrator.near_derivatives();
  return result;
}

namespace {

template <class AnyIntegrator>
Trajectory integrate(System& system, AnyIntegrator& integrator, TimedForces& whole,
                     TimedForces* near, const TrajectorySettings& settings, const Watch& watch,
                     Workers& workers, const RunState* from) {
  Trajectory result;
  TrajectoryStatistics& statistics = result.statistics;
  const ErrorTerms terms = error_terms(settings.scheme);
  const std::size_t steps = settings.steps(), interval = settings.steps_per_sample();
  double start = system.state.time;
  if (from) {
    system.state = from->state;
    start = from->start;
    result.steps = from->steps;
    statistics = from->statistics;
    integrator.resume_from(from->integrator);
    whole.forces.resume_from(from->list, system.state.box);
    if (near) near->forces.resume_from(from->near_list, system.state.box);
  }
  Clocks clocks(whole, near, from ? from->timings : Timings{});

  const auto checkpoint = [&] {
    if (!watch.checkpoint) return;
    clocks.add_motion();
    watch.checkpoint({system.state, std::nullopt, result.steps, start, integrator.memory(),
                      whole.forces.list_memory(system.state.box),
                      near ? near->forces.list_memory(system.state.box) : ListMemory{}, statistics,
                      clocks.timings()});
    clocks.skip();
  };
  Load complete;
  const auto all_forces =
      [&]() -> const Load& {  // with an inner scheme, the outer one has the slow forces
    if (!near) return integrator.last_load();
    whole.forces.forces_alone(system.state, complete);
    return complete;
  };
  const auto signs_at = [&](std::size_t done) {
    constexpr std::uint64_t streams = std::uint64_t{1}
                                      << 32;  // initial configurations use those below it
    return Random(settings.seed, streams + done);
  };
  const auto sample = [&] {
    clocks.add_motion();
    const double forces_before = clocks.in_forces();
    Energies now;
    try {
      now = energies(system.state, system.bodies, integrator.load(system.state), workers);
    } catch (const RunError& e) {
      throw_blow_up(settings, result.steps, e.what() + inner_limit_note(system.topology));
    }
    clocks.forces_of_sample(clocks.in_forces() - forces_before);
    if (!std::isfinite(now.total()))
      throw_blow_up(
          settings, result.steps,
          "the total energy is no longer a finite number" + inner_limit_note(system.topology));
    if (watch.sample) watch.sample(result.steps, system.state, now);
    const auto due = [&](double every) {
      return every > 0 && statistics.energies.samples % settings.samples_per(every) == 0;
    };
    if (due(settings.configurational_sample))
      statistics.configurational.add(configurational_sample(
          system.state, system.bodies, all_forces(), whole.forces, signs_at(result.steps)));
    if (due(settings.shadow_sample)) {
      const BracketSample both{
          now, error_brackets(system.state, system.bodies, integrator.last_load(), whole.forces)};
      statistics.shadow.add(now.time, shadow_energy(both, terms, settings.step));
      if (watch.brackets) watch.brackets(both);
    }
    statistics.energies.add(now);
    const Energies& first = statistics.energies.first;
    if (settings.stretch > 0)
      statistics.stretches.add(now, first, settings.samples_per(settings.stretch));
    if (std::abs(now.total() - first.total()) > first.kinetic() && first.kinetic() > 0)
      throw_blow_up(settings, result.steps,
                    fmt::format("the total energy went from {:.6g} to {:.6g} kJ/mol, more than the "
                                "initial kinetic energy",
                                first.total(), now.total()));
    clocks.skip();
  };
  const auto step = [&](bool energies) {
    try {
      integrator.advance(system.state, settings.step, 1, energies);
    } catch (const RunError& e) {
      throw_blow_up(settings, result.steps + 1, e.what() + inner_limit_note(system.topology));
    }
    ++result.steps;
    system.state.time = start + static_cast<double>(result.steps) * settings.step;
    if (!std::isfinite(integrator.last_load().potential()))
      throw_blow_up(
          settings, result.steps,
          "the potential energy is no longer a finite number" + inner_limit_note(system.topology));
  };

  try {
    if (statistics.energies.samples == 0) {
      checkpoint();
      sample();
    }
    while (result.steps < steps &&
           !result.stopped) {  // one by one, so that a failed step is identified
      const bool sampled = (result.steps + 1) % interval == 0;
      step(sampled);
      if (sampled) sample();
      result.stopped = watch.stop && watch.stop();
      if (result.stopped || result.steps == steps || (watch.due && watch.due())) checkpoint();
    }
    if (result.steps % interval != 0) sample();
  } catch (const BlowUp& e) {
    result.failure = e.what();
  }
  clocks.add_motion();

  result.force_evaluations = integrator.force_evaluations();
  result.derivatives = integrator.derivatives();
  result.measurements = integrator.measurements();
  result.list_rebuilds = whole.forces.list_rebuilds();
  result.timings = clocks.timings();
  return result;
}

}  // namespace

bool equilibrate(System& system, ForceField& forces, double length, const Watch& watch,
                 Workers& workers, const RunState* from) {
  constexpr double step = 0.001, interval = 0.02;  // [ps]
  const Scheme scheme = scheme_of("velocity-verlet");
  const Watch within{watch.sample, watch.stop};
  double done = 0;
  if (from) {
    system.state = from->state;
    done = from->equilibrated.value();
    forces.resume_from(from->list, system.state.box);
  }
  while (done < length) {
    RunState here;  // an unfinished piece is repeated
    if (watch.checkpoint)
      here = {.state = system.state,
              .equilibrated = done,
              .list = forces.list_memory(system.state.box)};
    rescale(system.state, system.topology, system.bodies, system.temperature);
    const double piece = std::min(interval, length - done);
    const Trajectory part = run_trajectory(
        system, forces, {scheme, step, std::max(piece, step), interval}, within, workers);
    done += piece;
    if (!part.failure.empty()) throw RunError("while equilibrating, " + part.failure);
    if (watch.checkpoint && (part.stopped || (watch.due && watch.due())))
      watch.checkpoint(std::move(here));
    if (part.stopped) return false;
  }
  rescale(system.state, system.topology, system.bodies, system.temperature);
  system.state.time = 0;
  return true;
}

}  // namespace polhode
