// SPDX-License-Identifier: MIT
#include "polhode/run/simulation/trajectory/trajectory_settings.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "integrate/postprocessor.hpp"
#include "io/settings/output_units.hpp"
#include "polhode/base/error.hpp"
#include "polhode/integrate/error_terms.hpp"
#include "polhode/integrate/with_bath.hpp"
#include "polhode/io/settings/nested_scheme_text.hpp"
#include "run/simulation/trajectory/ensemble_moves.hpp"

namespace polhode {
namespace {

constexpr double max_steps = 0x1p53;  // largest number of steps that a double can count

/// The name of a scheme with a bath, such as "hoa2-ends", if the name is short enough. The name is
/// empty for a scheme given only by stages.
std::string name_with_bath(const Scheme& scheme) {
  if (!scheme.in_table() && !scheme.has_own_name()) return "";
  if (scheme.name() == "velocity-verlet") return "obabo";
  const std::string name = std::string(scheme.name()) + "-ends";
  return name.size() <= Scheme::max_name ? name : "";
}

/// Checks external forces. Cell rescaling and the pressure tensor need the virial of these forces.
void check_external(const Config& config) {
  const ExternalForces* const external = config.forces.external.get();
  const auto& barostat = config.ensemble.barostat;
  if (external && !external->has_virial && barostat &&
      std::holds_alternative<CellRescaling>(barostat->type))
    throw Error(fmt::format(
        "the forces '{}' have no virial, but the barostat cell-rescaling needs the virial for the "
        "pressure; add a virial to these forces, or choose the barostat monte-carlo",
        external->name));
  if (external && !external->has_virial && config.output.pressure_tensor)
    throw Error(fmt::format(
        "the forces '{}' have no virial, but output.pressure_tensor = true needs the virial; add a "
        "virial to these forces, or leave the pressure tensor out",
        external->name));
}

}  // namespace

std::size_t TrajectorySettings::steps_in(double time) const {
  if (!(time / step <= max_steps))
    throw Error(
        fmt::format("{:g} ps in steps of {:g} fs are {:.3g} steps; the maximum is {:.3g} steps, so "
                    "use a shorter length",
                    time, step * units::fs_per_ps, time / step, max_steps));
  const auto all = static_cast<std::size_t>(std::llround(time / step));
  const std::size_t whole = steps_per_trajectory();
  return (all + whole - 1) / whole * whole;
}

std::size_t TrajectorySettings::steps_per_trajectory() const {
  return ensemble.hybrid_monte_carlo ? ensemble.hybrid_monte_carlo->steps : 1;
}

// Within a trajectory of hybrid Monte Carlo, a barostat move would change the energy on which
// acceptance depends; moreover, a rejection would undo the move.
std::size_t TrajectorySettings::steps_per_move() const {
  const std::size_t whole = steps_per_trajectory();
  const double trajectories =
      std::min(ensemble.barostat.value().every / step, max_steps) / static_cast<double>(whole);
  return whole * std::max<std::size_t>(1, static_cast<std::size_t>(std::llround(trajectories)));
}

double TrajectorySettings::move_interval() const {
  return static_cast<double>(steps_per_move()) * step;
}

std::size_t TrajectorySettings::steps_per_sample() const {
  const double every = std::min(sample / step * (1 + 1e-12), max_steps);
  const std::size_t steps = std::max<std::size_t>(1, static_cast<std::size_t>(every));
  const std::size_t whole = steps_per_trajectory();  // only the end of a trajectory is a sample
  return (steps + whole - 1) / whole * whole;
}

std::size_t TrajectorySettings::samples_per(double interval) const {
  const double samples = interval / (static_cast<double>(steps_per_sample()) * step) * (1 + 1e-12);
  return std::max<std::size_t>(1, static_cast<std::size_t>(std::min(samples, max_steps)));
}

ErrorTerms TrajectorySettings::error_terms() const {
  const ErrorTerms of_scheme = polhode::error_terms(scheme);
  const Postprocessor* const known = processed ? postprocessor_of(scheme) : nullptr;
  return known ? known->error_terms(of_scheme) : of_scheme;
}

bool TrajectorySettings::has_shadow() const {
  constexpr double rounding = 1e-12;  // round-off of coefficients with 15 digits
  const ErrorTerms terms = error_terms();
  return !inner && polhode::fixed_means(ensemble, scheme) && scheme.palindromic() &&
         std::hypot(terms.alpha, terms.beta) > rounding;
}

std::optional<FixedMeans> TrajectorySettings::fixed_means() const {
  const auto fixed = polhode::fixed_means(ensemble, scheme);
  return fixed == FixedMeans::energy || has_shadow() ? fixed : std::nullopt;
}

void TrajectorySettings::check_shadow() const {
  if (shadow_sample == 0 || has_shadow()) return;
  if (inner)
    throw Error(fmt::format(
        "shadow_sample is {:g} fs, but the scheme {} has an inner scheme, for which no shadow "
        "energy is known; leave shadow_sample out, or use a single scheme, such as hoa2",
        shadow_sample * units::fs_per_ps, name_of({scheme, inner})));
  if (!polhode::fixed_means(ensemble, scheme))
    throw Error(fmt::format(
        "shadow_sample is {:g} fs, but this ensemble has no shadow energy; leave shadow_sample "
        "out, or use type = \"rescaling\" in [thermostat] with the bath at the ends of "
        "steps, and edges = [\"xyz\"] in [barostat]",
        shadow_sample * units::fs_per_ps));
  const char* const reason =
      scheme.palindromic()
          ? "no error of order h², so its shadow energy equals the energy to this order"
          : "an error of order h, since its stages are not a palindrome";
  throw Error(
      fmt::format("shadow_sample is {:g} fs, but {} has {}; leave shadow_sample out, or use a "
                  "palindrome of order 2, "
                  "such as hoa2",
                  shadow_sample * units::fs_per_ps, name_of(NestedScheme(scheme)), reason));
}

void TrajectorySettings::check_processed() const {
  if (!processed) return;
  if (!ensemble.constant_energy())
    throw Error(
        "output.processed is true, but the run is not at constant energy: a thermostat, a barostat "
        "or hybrid Monte Carlo acts on the states of the trajectory, and the states that are read "
        "would have another temperature and pressure; leave output.processed out, or the tables "
        "[thermostat], [barostat] and [hybrid_monte_carlo]");
  if (inner || !postprocessor_of(scheme))
    throw Error(fmt::format(
        "output.processed is true, but no postprocessor is known for the scheme {}; use "
        "velocity-verlet, takahashi-imada, takahashi-imada-fd, gier4 or gier4-fd, or leave "
        "output.processed out",
        name_of({scheme, inner})));
}

TrajectorySettings trajectory_settings(const Config& config, double stretch) try {
  NestedScheme scheme = config.integrator.scheme;
  if (config.ensemble.thermostat && !scheme.has(Flow::bath))
    scheme.outer = with_bath(scheme.outer, BathPlace::ends, name_with_bath(scheme.outer));
  TrajectorySettings settings{.scheme = scheme.outer,
                              .step = config.integrator.step,
                              .length = config.run.length,
                              .sample = config.run.sample,
                              .lambda = config.integrator.lambda,
                              .inner = scheme.inner,
                              .configurational_sample = config.run.configurational_sample,
                              .seed = config.system.seed,
                              .stretch = stretch,
                              .ensemble = config.ensemble,
                              .processed = config.output.processed};
  settings.ensemble.temperature = config.system.temperature;
  check_ensemble(settings);
  check_external(config);
  if (settings.length < settings.step * (1 - 1e-9))
    throw Error(fmt::format(
        "the step of {:g} fs is longer than the length of {:g} fs; use a shorter step, or a longer "
        "length",
        settings.step * units::fs_per_ps, settings.length * units::fs_per_ps));
  settings.steps();
  settings.check_processed();
  constexpr double steps_per_shadow = 100;  // interval that costs about 1 % of a run
  settings.shadow_sample = config.run.shadow_sample.value_or(
      settings.has_shadow() ? steps_per_shadow * settings.step : 0);
  settings.check_shadow();
  return settings;
} catch (const Error& e) {
  throw e.at(config.source);
}

}  // namespace polhode
