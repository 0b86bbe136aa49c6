// SPDX-License-Identifier: MIT
// The changes that the time-step error causes in averages and in functions of averages. One
// trajectory gives these changes (docs/theory.md, Eqs. (47) to (54)).
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

/// The means that an ensemble fixes, which are therefore equal in trajectories with different time
/// steps.
enum class FixedMeans {
  energy,                       ///< the mean total energy, at constant energy
  kinetic_energy,               ///< the mean kinetic energy, with a rescaling thermostat
  kinetic_energy_and_pressure,  ///< the mean kinetic energy and the mean pressure, with stochastic
                                ///< cell rescaling
  /// The mean kinetic energy, and a mean pressure with N kT/V in place of its kinetic part. Monte
  /// Carlo barostats fix this pressure, because their volume moves do not use momenta.
  kinetic_energy_and_pressure_of_positions
};

/// The means that an ensemble fixes. The result is empty if the shadow energy does not determine
/// the distribution. Examples are runs with a Langevin thermostat, with separate rescaling of
/// translation and rotation, or with a bath within the steps. The result is also empty if a
/// barostat scales edges separately, because the barostat then controls several pressures. The
/// result is empty with hybrid Monte Carlo, which has no time-step bias.
std::optional<FixedMeans> fixed_means(const EnsembleSettings& settings, const Scheme& scheme);
/// The means that an ensemble fixes, for all schemes without bath stages within a step.
std::optional<FixedMeans> fixed_means(const EnsembleSettings& settings);

/// The data of a sample from which the time-step bias of any average is computed: energies,
/// pressure and volume.
struct StepError {
  double error = 0;  ///< difference H̃ − H of shadow energy and energy, up to a constant [kJ/mol]
  double total = 0;     ///< total energy H [kJ/mol]
  double kinetic = 0;   ///< kinetic energy [kJ/mol]
  double pressure = 0;  ///< pressure that a barostat controls [kJ/mol/nm³]
  double volume = 0;    ///< volume [nm³]
};

/// The time-step error of a sample. At constant energy, the time-step error is a constant minus the
/// energy.
/// @param ideal  ideal-gas term N kT of N bodies at the temperature of the thermostat [kJ/mol]
StepError step_error(const Energies& now, FixedMeans fixed, double ideal);

/// Sums over samples, in blocks of time. The terms are quantities relative to the first sample, and
/// products of these quantities with the time-step error.
struct StepResponse {
  /// A function of the averages of all quantities. The averages are in the order of the quantities.
  using Function = std::function<double(std::span<const double>)>;

  std::vector<double> first;
  TimeBlocks blocks;

  /// Adds a sample.
  /// @param quantities  values of the quantities, equally many in each sample
  void add(const StepError& at, std::span<const double> quantities);
  std::size_t samples() const;
  /// The bias of a function of averages, to leading order, with its standard error.
  /// @param degrees_of_freedom  number of degrees of freedom of the kinetic energy
  SeriesEstimate bias(double degrees_of_freedom, FixedMeans fixed, const Function& f) const;
  /// Makes all sums relative to the given sample instead of the first sample.
  StepResponse relative_to(const std::vector<double>& other) const;
};

/// The time-step bias from independent runs. The sums of all runs must be relative to the same
/// sample.
SeriesEstimate step_bias(std::span<const StepResponse> runs, double degrees_of_freedom,
                         FixedMeans fixed, const StepResponse::Function& f);

}  // namespace polhode
