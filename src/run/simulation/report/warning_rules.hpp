// SPDX-License-Identifier: MIT
// Rules for warnings about simulations that are probably wrong.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "polhode/io/settings/config.hpp"
#include "polhode/run/simulation/report/summary.hpp"
#include "polhode/run/simulation/report/warnings.hpp"

namespace polhode {

/// Number of standard deviations beyond which a difference is not due to chance, if the standard
/// deviation is known. For an estimated standard deviation, three_sigma() is used.
constexpr double far = 3;

/// The p-value below which a slope causes a warning. This p-value is a tenth of the usual
/// significance level, because slopes are tested in every run.
constexpr double significance_level = 0.001;

/// The largest R of a run without a warning. Predictions of the time-step bias are used below it.
constexpr double max_ratio = 0.05;

/// "warning: text; remedy".
std::string line_of(const Warning& warning);

/// Adds those warnings of a list that are given.
void append(std::vector<Warning>& all, std::initializer_list<std::optional<Warning>> more);

/// Warns of ions without interactions beyond the cutoff: molecules have a net charge, and
/// electrostatics are plain Coulomb or a reaction field. The value of the warning is the largest
/// net charge [e].
std::optional<Warning> cutoff_of_ions(const System& system);

/// A warning about a molecule with a site that is so far from all other sites that no bond is
/// plausible. The likely cause is that positions are in ångström instead of nm.
std::optional<Warning> distant_sites(const System& system);

/// Warns if velocities of the initial configuration do not have the temperature of the run file,
/// and no thermostat changes their temperature. The warning requires a deviation of more than four
/// standard deviations of a canonical kinetic temperature, T √(2/n) for n degrees of freedom.
std::optional<Warning> velocities_of_file(const System& system, const Config& config);

/// Warns if the step exceeds max_stable_step() in the current state of the system. The value of the
/// warning is the step times the Einstein frequency of the fastest degrees of freedom.
std::optional<Warning> step_near_stability(const System& system, const TrajectorySettings& settings,
                                           Workers& workers = Workers::serial());

/// Warns of a truncation that is not smooth enough for scheme and step. The warning is given if the
/// predicted random walk of the total energy exceeds 0.1 % of the fluctuation of the potential
/// energy. The fluctuation of the potential energy is estimated by the canonical fluctuation of the
/// kinetic energy, kT √(n/2) for n degrees of freedom. The value of the warning is the R of the
/// random walk.
std::optional<Warning> rough_truncation(const System& system, const TrajectorySettings& settings);

/// All warnings about ions, the time step and the results of a run (docs/manual/outputs.md,
/// Warnings).
std::vector<Warning> warnings(const RunSummary& summary, const System& system,
                              const TrajectorySettings& settings, const Config& config,
                              Workers& workers = Workers::serial());

/// The temperature that a run file asks for.
struct TargetTemperature {
  double value = 0;      ///< [K]
  bool ignored = false;  ///< whether this temperature has no effect, because the run keeps the
                         ///< velocities of the initial configuration
  bool kept = false;     ///< whether a thermostat or hybrid Monte Carlo controls the temperature
};

/// The warnings that follow from the results of a run.
/// @param target  target temperature; empty if any temperature is valid
std::vector<Warning> warnings_of_results(const RunSummary& summary,
                                         const std::optional<TargetTemperature>& target);

/// Warnings about the ensemble of a run. Causes of warnings are a drifting volume, too few accepted
/// barostat moves, too few or too many accepted trajectories of hybrid Monte Carlo, and a mean of
/// exp(−ΔH/kT) that is not 1 (docs/manual/ensembles.md, Warnings).
std::vector<Warning> ensemble_warnings(const RunSummary& summary);

/// The relaxation time of the volume [ps]. For cell rescaling, the relaxation time equals the time
/// constant if the system has the compressibility of the barostat settings. A more compressible
/// system relaxes more slowly.
/// @param compressibility  compressibility of the system [nm³ mol/kJ]; 0 if it is not known
double volume_relaxation(const BarostatSettings& barostat, double compressibility);

/// Whether the contribution of the energy drift to R exceeds half of R, and also exceeds 0.1 %.
bool drift_matters(const RunSummary& summary);

}  // namespace polhode
