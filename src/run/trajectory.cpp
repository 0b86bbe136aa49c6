// SPDX-License-Identifier: MIT
#include "polhode/run/trajectory.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "polhode/base/error.hpp"
#include "polhode/integrate/nested_forces.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/io/nested_scheme_text.hpp"
#include "polhode/run/near_forces.hpp"

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

/// Forces, with a clock.
struct TimedForces {
  ForceField& forces;
  double seconds = 0;  // with the list
  double list_before = forces.neighbours().seconds();
  double list() const { return forces.neighbours().seconds() - list_before; }
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
};

[[noreturn]] void blown_up(const TrajectorySettings& s, std::size_t step, const std::string& what) {
  throw RunError(
      fmt::format("the run blew up at step {} ({:.4f} ps): {}; the step of {:g} fs is too long for "
                  "{}, or the start "
                  "is too rough: try {:g} fs, or equilibrate first",
                  step, static_cast<double>(step) * s.step, what, s.step * 1000,
                  name_of({s.scheme, s.inner}), s.step * 500));
}

/// The trajectory of an integrator.
/// @param whole, near  what it evaluates; near is empty without an inner scheme
template <class Model>
Trajectory followed(System& system, Integrator<Model>& integrator, const TimedForces& whole,
                    const TimedForces* near, const TrajectorySettings& settings, const Watch& watch,
                    Workers& workers);

}  // namespace

std::size_t TrajectorySettings::steps() const {
  return static_cast<std::size_t>(std::llround(length / step));
}

std::size_t TrajectorySettings::steps_per_sample() const {
  return std::max<std::size_t>(1, static_cast<std::size_t>(sample / step * (1 + 1e-12)));
}

Trajectory trajectory(System& system, ForceField& forces, const TrajectorySettings& settings,
                      const Watch& watch, Workers& workers) {
  TimedForces whole{forces};
  if (!settings.inner) {
    Integrator integrator(settings.scheme, system.bodies, whole, settings.lambda, workers);
    return followed(system, integrator, whole, nullptr, settings, watch, workers);
  }
  ForceField near_forces(system.topology, near_settings(forces.settings(), *settings.inner),
                         system.state.box, workers);
  TimedForces near{near_forces};
  NestedForces nested(settings.inner->scheme, settings.inner->steps, system.bodies, whole, near,
                      settings.lambda, workers);
  Integrator integrator(settings.scheme, system.bodies, nested, settings.lambda, workers);
  Trajectory result = followed(system, integrator, whole, &near, settings, watch, workers);
  result.near_evaluations = nested.near_evaluations();
  return result;
}

namespace {

template <class Model>
Trajectory followed(System& system, Integrator<Model>& integrator, const TimedForces& whole,
                    const TimedForces* near, const TrajectorySettings& settings, const Watch& watch,
                    Workers& workers) {
  Trajectory result;
  const std::size_t steps = settings.steps(), interval = settings.steps_per_sample();
  const auto in_forces = [&] { return whole.seconds + (near ? near->seconds : 0); };
  double motion = 0;
  Stopwatch run, part;

  double forces_of_samples = 0;  // schemes that end with a drift need forces for the energy
  const auto sample = [&] {
    motion += part.lap();
    const double forces_before = in_forces();
    const Energies now =
        energies(system.state, system.bodies, integrator.load(system.state), workers);
    forces_of_samples += in_forces() - forces_before;
    if (!std::isfinite(now.total()))
      blown_up(settings, result.steps, "the total energy is no longer a finite number");
    result.samples.push_back(now);
    const Energies& start = result.samples.front();
    if (std::abs(now.total() - start.total()) > start.kinetic() && start.kinetic() > 0)
      blown_up(
          settings, result.steps,
          fmt::format("the total energy went from {:.6g} to {:.6g} kJ/mol, more than the kinetic "
                      "energy at the start",
                      start.total(), now.total()));
    if (watch.sample) watch.sample(result.steps, system.state, now);
    part.lap();
  };
  const auto step = [&](bool energies) {
    try {
      integrator.advance(system.state, settings.step, 1, energies);
    } catch (const RunError& e) {
      blown_up(settings, result.steps + 1, e.what());
    }
    ++result.steps;
    if (!std::isfinite(integrator.last_load().potential()))
      blown_up(settings, result.steps, "the potential energy is no longer a finite number");
  };

  const double start_time = system.state.time;
  try {
    sample();
    while (result.steps < steps && !result.stopped) {
      const std::size_t next = std::min(result.steps + interval, steps);
      while (result.steps < next && !result.stopped) {  // one by one: a step that fails is known
        step(result.steps + 1 == next);
        result.stopped = watch.stop && watch.stop();
      }
      system.state.time = start_time + static_cast<double>(result.steps) * settings.step;
      sample();
    }
  } catch (const RunError& e) {
    result.failure = e.what();
  }
  motion += part.lap();

  result.force_evaluations = integrator.force_evaluations();
  result.measurements = integrator.measurements();
  result.timings = {.forces = whole.seconds - whole.list(),
                    .near = near ? near->seconds - near->list() : 0,
                    .list = whole.list() + (near ? near->list() : 0),
                    .motion = motion - (in_forces() - forces_of_samples)};
  result.timings.measurement = std::max(0.0, run.lap() - result.timings.all());
  return result;
}

}  // namespace

bool equilibrate(System& system, ForceField& forces, double length, const Watch& watch,
                 Workers& workers) {
  constexpr double step = 0.001, interval = 0.02;  // [ps]
  const Scheme scheme = scheme_of("velocity-verlet");
  double done = 0;
  while (done < length) {
    rescale(system.state, system.topology, system.bodies, system.temperature);
    const double piece = std::min(interval, length - done);
    const Trajectory part =
        trajectory(system, forces, {scheme, step, std::max(piece, step), interval}, watch, workers);
    done += piece;
    if (!part.failure.empty()) throw RunError("while equilibrating, " + part.failure);
    if (part.stopped) return false;
  }
  rescale(system.state, system.topology, system.bodies, system.temperature);
  system.state.time = 0;
  return true;
}

}  // namespace polhode
