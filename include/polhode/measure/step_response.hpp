// SPDX-License-Identifier: MIT
// What the error of the step changes in averages, and in functions of averages, from the trajectory
// itself (docs/theory.md, Eqs. (47) to (53)).
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "polhode/integrate/scheme.hpp"
#include "polhode/measure/correlated_series.hpp"
#include "polhode/measure/energy.hpp"
#include "polhode/model/ensemble_settings.hpp"

namespace polhode {

/// What two trajectories with different steps have in common when their averages are compared.
enum class FixedMeans {
  energy,                       ///< constant energy: that of the total energy
  kinetic_energy,               ///< rescaling thermostat: that of the kinetic energy
  kinetic_energy_and_pressure,  ///< with cell rescaling: those of both
  /// With Monte Carlo moves of the volume, which know no momenta: those of the kinetic energy and
  /// of the pressure with N kT/V in place of its kinetic part.
  kinetic_energy_and_pressure_of_positions
};

/// Nothing where the distribution is not that of a shadow energy: with a Langevin thermostat, with
/// translation and rotation thermostatted apart, with a bath within the steps; nothing with a
/// barostat of other edges than all three by one factor, which holds several pressures; and nothing
/// where there is no bias: hybrid Monte Carlo.
std::optional<FixedMeans> fixed_means(const EnsembleSettings& settings, const Scheme& scheme);
/// Of any scheme without a bath within its steps.
std::optional<FixedMeans> fixed_means(const EnsembleSettings& settings);

/// A sample of what the bias depends on, besides the quantities that are averaged.
struct StepError {
  double error = 0;     ///< H̃ − H, up to a constant [kJ/mol]
  double total = 0;     ///< H [kJ/mol]
  double kinetic = 0;   ///< [kJ/mol]
  double pressure = 0;  ///< the one that a barostat holds [kJ/mol/nm³]
  double volume = 0;    ///< [nm³]
};

/// Of a sample. At constant energy H̃ is constant, so that its error is what the energy lacks.
/// @param ideal  N kT of N bodies at the temperature of the thermostat [kJ/mol]
StepError step_error(const Energies& now, FixedMeans fixed, double ideal);

/// Sums over samples of any quantities and of their products with the error of the step, in blocks
/// of time, relative to the first sample.
struct StepResponse {
  /// Of the averages of all quantities, in their order.
  using Function = std::function<double(std::span<const double>)>;

  std::vector<double> first;
  TimeBlocks blocks;

  /// @param quantities  as many in each sample
  void add(const StepError& at, std::span<const double> quantities);
  std::size_t samples() const;
  /// The bias of a function of averages, to leading order, with its standard error.
  /// @param degrees_of_freedom  of the kinetic energy
  SeriesEstimate bias(double degrees_of_freedom, FixedMeans fixed, const Function& f) const;
};

}  // namespace polhode
