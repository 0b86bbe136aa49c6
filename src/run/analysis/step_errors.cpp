// SPDX-License-Identifier: MIT
#include "polhode/run/analysis/step_errors.hpp"

#include <fmt/core.h>

#include <cmath>

#include "polhode/base/error.hpp"
#include "polhode/base/units.hpp"
#include "polhode/io/settings/nested_scheme_text.hpp"

namespace polhode {
namespace {

/// The round-off of times in files [ps]. Times have six decimals in text files, and are floats in
/// binary files.
double rounding(double time) { return 0.6e-6 + 0x1p-22 * std::abs(time); }

}  // namespace

StepErrorSettings step_error_settings(const std::string& energies, const Config& config) {
  const EnsembleSettings& ensemble = config.ensemble;
  if (const auto fixed = fixed_means(ensemble, config.integrator.scheme.outer))
    return {energies, *fixed, config.system.temperature};
  if (ensemble.hybrid_monte_carlo)
    throw Error("hybrid Monte Carlo has no time-step bias; leave the energies out");
  throw Error(
      "the time-step bias is known only at constant energy, or with a rescaling thermostat at the "
      "ends of steps and isotropic scaling of the box; leave the energies out");
}

StepErrors::StepErrors(const StepErrorSettings& settings, const Topology& topology)
    : settings_(settings), bodies_(topology), rows_(settings.energies) {
  next_ = rows_.next();
}

std::optional<StepError> StepErrors::at(const State& frame, bool has_velocities) {
  const double first = frame.time - rounding(frame.time), last = frame.time + rounding(frame.time);
  if (row_ && row_->energies.time > last)
    throw Error(
        fmt::format("the frame at {:.9g} ps is earlier than the previous frame; give a trajectory "
                    "whose times increase",
                    frame.time));
  while (next_ && next_->energies.time <= last) {
    if (next_->energies.time >= first && row_ && row_->energies.time >= first)
      throw Error(
          fmt::format("'{}' has several rows at {:.9g} ps, because times in files are rounded, so "
                      "the row of the frame is not known; use a longer interval between energies",
                      settings_.energies, frame.time));
    row_ = next_;
    next_ = rows_.next();
  }
  if (!row_ || row_->energies.time < first)
    throw Error(
        fmt::format("'{}' has no row at {:.9g} ps, the time of a frame; give the energies of the "
                    "run that wrote the trajectory",
                    settings_.energies, frame.time));
  check(*row_, frame, has_velocities);
  const double ideal = static_cast<double>(frame.size()) * units::boltzmann * settings_.temperature;
  const StepError error = step_error(row_->energies, settings_.fixed, ideal);
  return std::isnan(error.error) ? std::nullopt : std::optional(error);
}

void StepErrors::check(const EnergyRow& row, const State& frame, bool has_velocities) const {
  const auto refuse = [&](const char* what, double here, double there, const char* unit) {
    throw Error(
        fmt::format("the frame at {:.9g} ps has a {} of {:.6g} {}, but the row of this frame in "
                    "'{}' has {:.6g} {}; give the energies of the run that wrote the trajectory",
                    frame.time, what, here, unit, settings_.energies, there, unit));
  };
  const Energies& e = row.energies;
  constexpr double of_volume = 1e-4;  // relative tolerance: edges have at least five digits
  const double volume = frame.box.volume();
  if (!(std::abs(volume - e.volume) <= of_volume * e.volume))
    refuse("volume", volume, e.volume, "nm3");
  const double of_energy = 1e-12 * (std::abs(e.potential()) + e.kinetic());  // round-off of sums
  if (settings_.fixed == FixedMeans::energy && !(std::abs(row.conserved - e.total()) <= of_energy))
    throw Error(
        fmt::format("conserved and total energy in '{}' differ at {:.9g} ps, so the run had a "
                    "thermostat, but the run file has none; give the run file of that run",
                    settings_.energies, e.time));
  if (!has_velocities) return;
  // Rounding of positions to 0.001 nm changes the rotational energy of a molecule by a few per
  // cent.
  const double of_kinetic = 0.01 + 0.05 / std::sqrt(static_cast<double>(frame.size()));
  const double kinetic = energies(frame, bodies_, Load{}).kinetic();
  if (!(std::abs(kinetic - e.kinetic()) <= of_kinetic * e.kinetic()))
    refuse("kinetic energy", kinetic, e.kinetic(), "kJ/mol");
}

}  // namespace polhode
