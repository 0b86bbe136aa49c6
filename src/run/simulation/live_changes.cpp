// SPDX-License-Identifier: MIT
// Changes of the state and the settings of a simulation in progress. Each change begins a segment
// of the trajectory, because averages over different states or time steps are meaningless.
#include <fmt/core.h>

#include <cmath>
#include <utility>

#include "io/settings/config_parts.hpp"
#include "polhode/run/simulation/simulation.hpp"
#include "run/simulation/files/identity.hpp"
#include "run/simulation/system/near_forces.hpp"

namespace polhode {
namespace {

constexpr double max_position = 1e6;  // Maximum position [nm]. Beyond this value, a double resolves
                                      // less than 1e-10 nm.

[[noreturn]] void refuse(std::size_t body, const char* quantity, const Vec3<double>& v,
                         const std::string& complaint) {
  throw Error(fmt::format("the {} of molecule {} is ({:.6g}, {:.6g}, {:.6g}); {}", quantity,
                          body + 1, v.x, v.y, v.z, complaint));
}

void check_finite(std::size_t body, const char* quantity, const Vec3<double>& v) {
  if (!(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z)))
    refuse(body, quantity, v, "the components must be finite numbers");
}

/// Checks that the angular momentum along an axis with no moment of inertia is zero within the
/// round-off of the whole angular momentum.
void check_axes(std::size_t body, const Vec3<double>& ell, const Quaternion<double>& orientation,
                const Vec3<double>& J) {
  constexpr double rounding = 1e-9;
  const Vec3<double> L = to_body(orientation, ell);
  for (std::size_t k = 0; k < 3; ++k)
    if (J[k] == 0 && std::abs(L[k]) > rounding * norm(L))
      refuse(body, "angular momentum", ell,
             fmt::format("the component of {:.3g} u nm2/ps along its principal axis {} must be 0, "
                         "since the moment of inertia about this axis is 0",
                         L[k], k + 1));
}

/// Returns the orientation as a unit quaternion. If the quaternion is already normalized up to
/// round-off, its bits do not change.
Quaternion<double> checked_orientation(std::size_t body, const Quaternion<double>& s) {
  constexpr double rounding = 1e-14, smallest = 1e-100, largest = 1e100;
  const double squared = norm2(s);
  if (!(squared > smallest && squared < largest))
    throw Error(
        fmt::format("the orientation of molecule {} is ({:.6g}, {:.6g}, {:.6g}, {:.6g}); it must "
                    "be a quaternion (w, x, y, z) that can be normalized",
                    body + 1, s.w, s.x, s.y, s.z));
  return std::abs(squared - 1) < rounding ? s : normalized(s);
}

/// Checks positions, momenta, orientations and angular momenta, and normalizes the orientations.
/// @throws Error  if a number is not finite, a position is out of range, an orientation is zero, or
///   an angular momentum has a component along an axis with no moment of inertia. The message gives
///   the number of the molecule, counted from 1
void check_motion(State& state, const Bodies& bodies) {
  for (std::size_t i = 0; i < state.size(); ++i) {
    check_finite(i, "position [nm]", state.q[i]);
    if (!(norm(state.q[i]) <= max_position))
      refuse(i, "position [nm]", state.q[i],
             fmt::format("it must be within {:g} nm of the origin", max_position));
    check_finite(i, "momentum [u nm/ps]", state.p[i]);
    check_finite(i, "angular momentum [u nm2/ps]", state.ell[i]);
    const Quaternion<double> orientation = checked_orientation(i, state.orientation[i]);
    check_axes(i, state.ell[i], orientation, bodies.J[i]);
    state.orientation.set(i, orientation);
  }
}

/// Resets the counts of an integrator. Forces are evaluated again, and the evaluations are counted
/// from 0. The number of steps is not reset, because it selects the random numbers of a bath.
void begin_counts(IntegratorMemory& memory) {
  memory.current = false;
  memory.evaluations = memory.derivatives = memory.measurements = 0;
  for (IntegratorMemory& inner : memory.inner) begin_counts(inner);
}

void check_changes(const Config& from, const Config& to) {
  if (const std::string wrong = wrong_temperature(to); !wrong.empty())
    throw Error(fmt::format("temperature = {:g} K {}", to.system.temperature, wrong));
  if (to.ensemble.constant_energy() && to.system.temperature != from.system.temperature)
    throw Error(
        fmt::format("temperature = {:g} K has no meaning at constant energy, since the momenta "
                    "determine the temperature; add a thermostat, or change the momenta",
                    to.system.temperature));
  if (to.ensemble.hybrid_monte_carlo != from.ensemble.hybrid_monte_carlo)
    throw Error(
        "hybrid Monte Carlo cannot be added, removed or changed during a simulation, since steps "
        "are counted in whole trajectories; make a new simulation with this state");
}

}  // namespace

Segment Simulation::segment() const {
  return propagator_ ? propagator_->segment() : at_ ? at_->segment : Segment{};
}

State& Simulation::state_to_change() {
  identity();
  return system_.state;
}

void Simulation::state_changed() {
  check_motion(system_.state, system_.bodies);
  if (!trajectory_started()) {
    if (at_) at_->state = system_.state;
    return;
  }
  RunState now = next_segment("the state was changed");
  if (propagator_)
    propagator_->resume_from(now);
  else
    at_ = std::move(now);
}

void Simulation::change(const IntegratorSettings& integrator,
                        const EnsembleSettings& ensemble) try {
  Config to = config_;
  to.integrator = integrator;
  to.ensemble = ensemble;
  to.system.temperature = ensemble.temperature;
  check_changes(config_, to);
  const auto settings = integrator.accuracy ? std::nullopt : std::optional(trajectory_settings(to));
  if (settings) check_near(system_.forces, {settings->scheme, settings->inner}, config_.source);
  const std::string changes = differences(settings_text(config_), settings_text(to));
  if (changes.empty() && integrator.accuracy == config_.integrator.accuracy) return;

  if (trajectory_started()) {
    at_ = next_segment(changes);
    propagator_.reset();
  }
  config_ = std::move(to);
  settings_ = settings;
  guarantee_.reset();
  system_.temperature = ensemble.temperature;
  identity_.clear();
  settings_changed_ = true;
} catch (const Error& e) {
  throw e.at(config_.source);
}

// Several changes without a step between them begin a single segment.
RunState Simulation::next_segment(const std::string& changes) {
  RunState now = propagator_ ? propagator_->run_state() : *at_;
  now.state = system_.state;
  Segment& segment = now.segment;
  if (now.steps > segment.first_step) {
    segment = {.number = segment.number + 1,
               .first_step = now.steps,
               .earlier = simulated(this->settings(), segment, now.steps),
               .changes = changes};
  } else {
    segment.changes += (segment.changes.empty() ? "" : ", ") + changes;
  }
  now.start = now.state.time;
  begin_counts(now.integrator);
  now.list.rebuilds = now.near_list.rebuilds = 0;
  now.statistics = {};
  now.timings = {};
  now.ensemble = {};
  return now;
}

std::string Simulation::command_of(const std::string& command) const {
  const Segment now = segment();
  if (now.changes.empty()) return command;
  return fmt::format("{} (segment {} from step {}: {})", command, now.number, now.first_step,
                     now.changes);
}

}  // namespace polhode
