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

/// Means that are equal in two trajectories with different steps whose averages are compared.
enum class FixedMeans {
  energy,                       ///< the mean total energy, at constant energy
  kinetic_energy,               ///< the mean kinetic energy, with rescaling thermostat
  kinetic_energy_and_pressure,  ///< both means, with cell rescaling
  /// The mean kinetic energy and the mean pressure with N kT/V instead of its kinetic part, with
  /// Monte Carlo moves of the volume, which do not use momenta.
  kinetic_energy_and_pressure_of_positions
};

/// Empty if the shadow energy does not determine the distribution: with a Langevin thermostat, with
/// separate rescaling of translation and rotation, or with a bath within the steps. Empty with a
/// barostat that scales edges separately, which holds several pressures. Empty with hybrid Monte
/// Carlo, which has no bias.
std::optional<FixedMeans> fixed_means(const EnsembleSettings& settings, const Scheme& scheme);
/// Fixed means for any scheme without a bath within its steps.
std::optional<FixedMeans> fixed_means(const EnsembleSettings& settings);

/// A sample of the energies on which a bias depends, besides the averaged quantities.
struct StepError {
  double error = 0;     ///< H̃ − H, up to a constant [kJ/mol]
  double total = 0;     ///< H [kJ/mol]
  double kinetic = 0;   ///< [kJ/mol]
  double pressure = 0;  ///< the one that a barostat holds [kJ/mol/nm³]
  double volume = 0;    ///< [nm³]
};

/// The time-step error of a sample: at constant energy, a constant minus the energy.
/// @param ideal  N kT of N bodies at the temperature of the thermostat [kJ/mol]
StepError step_error(const Energies& now, FixedMeans fixed, double ideal);

/// Sums over samples of quantities and of their products with the time-step error, in blocks of
/// time, relative to the first sample.
struct StepResponse {
  /// A function of the averages of all quantities, in their order.
  using Function = std::function<double(std::span<const double>)>;

  std::vector<double> first;
  TimeBlocks blocks;

  /// @param quantities  the same number in each sample
  void add(const StepError& at, std::span<const double> quantities);
  std::size_t samples() const;
  /// The bias of a function of averages, to leading order, with its standard error.
  /// @param degrees_of_freedom  of the kinetic energy
  SeriesEstimate bias(double degrees_of_freedom, FixedMeans fixed, const Function& f) const;
  /// These sums relative to another first sample.
  StepResponse relative_to(const std::vector<double>& other) const;
};

/// The bias from independent runs, whose sums are relative to the same first sample.
SeriesEstimate step_bias(std::span<const StepResponse> runs, double degrees_of_freedom,
                         FixedMeans fixed, const StepResponse::Function& f);

}  // namespace polhode
