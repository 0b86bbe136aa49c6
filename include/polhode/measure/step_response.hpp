// SPDX-License-Identifier: MIT
// What the error of the step changes in averages, and in functions of averages, from the trajectory
// itself (docs/theory.md, Eqs. (47) to (50)).
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
  energy,                      ///< constant energy: that of the total energy
  kinetic_energy,              ///< rescaling thermostat: that of the kinetic energy
  kinetic_energy_and_pressure  ///< with a barostat: those of both
};

/// Nothing where the distribution is not that of a shadow energy: with a Langevin thermostat, with
/// translation and rotation thermostatted apart, with a bath within the steps; and nothing where
/// there is no bias: hybrid Monte Carlo.
std::optional<FixedMeans> fixed_means(const EnsembleSettings& settings, const Scheme& scheme);

/// A sample of what the bias depends on, besides the quantities that are averaged.
struct StepError {
  double error = 0;     ///< H̃ − H, up to a constant [kJ/mol]
  double total = 0;     ///< H [kJ/mol]
  double kinetic = 0;   ///< [kJ/mol]
  double pressure = 0;  ///< [kJ/mol/nm³]
  double volume = 0;    ///< [nm³]
};

/// Of a sample. At constant energy H̃ is constant, so that its error is what the energy lacks.
StepError step_error(const Energies& now, FixedMeans fixed);

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
