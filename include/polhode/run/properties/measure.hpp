// SPDX-License-Identifier: MIT
// Measures properties of a model at state points, each to a requested error.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "polhode/base/workers.hpp"
#include "polhode/io/settings/config.hpp"
#include "polhode/measure/correlated_series.hpp"
#include "polhode/measure/radial_distribution.hpp"
#include "polhode/run/callbacks.hpp"
#include "polhode/run/outputs.hpp"
#include "polhode/run/quantities.hpp"

namespace polhode {

/// A row of the table of measurable properties, with the definition of the property.
struct Property;

/// A state point at which properties are measured.
struct StatePoint {
  double temperature = 0;  ///< temperature [K]
  double pressure = 0;     ///< pressure [kJ/mol/nm³]; NaN at constant volume
  double density = 0;      ///< mass density [u/nm³] at constant volume; 0 at constant pressure

  bool constant_volume() const { return density > 0; }
  /// The state point as text: "298.15 K, 1 bar" or "298.15 K, 997 kg/m3".
  std::string text() const;
  /// The state point as text for file names: "298.15K-1bar" or "298.15K-997kgm3".
  std::string file_text() const;
};

struct RequestedProperty {
  const Property* property = nullptr;
  double error = 0.01;   ///< requested standard error
  bool relative = true;  ///< whether the error is relative to the value; if false, it is in the
                         ///< unit of the property
};

/// How averages are sampled: by molecular dynamics, with a time-step bias that is predicted and
/// subtracted, or by hybrid Monte Carlo, without any.
enum class Sampling { molecular_dynamics, hybrid_monte_carlo };

/// The share of a process in the work: the process computes the replicas with numbers equal to
/// `index` modulo `count`.
struct Shard {
  std::uint64_t index = 0, count = 1;
};

struct MeasureSettings {
  Config config;  ///< settings of molecules, forces and seed
  std::vector<StatePoint> points;
  std::vector<RequestedProperty> properties;
  std::uint64_t replicas = 4;  ///< number of independent simulations of each state point
  Shard shard{};
  double time_limit = 0;  ///< limit of the wall-clock time [s]; 0: no limit
  std::string prefix = "measure";
  std::string command = "polhode measure";  ///< command that is recorded in outputs
  std::vector<std::string> notes{};         ///< what was assumed about the system, for the user
  /// Whether a part of the dynamics is repeated at half of the step, which bounds its time-step
  /// bias.
  bool paired_runs = true;
  Sampling sampling{};          ///< of averages, stages of a coupling and slabs
  std::string scheme = "hoa2";  ///< scheme of all runs but the preparation
  double step = 0;              ///< time step [ps]; 0: a pilot chooses it
  bool only_evaluate = false;   ///< whether to evaluate existing records without new computations
};

/// A bound of the time-step bias from runs at the step and at half of it, which begin in the same
/// states.
struct StepBound {
  SeriesEstimate difference;  ///< value at the step minus value at half of it
  double bound = 0;           ///< of the magnitude of the bias, with 95 % probability
  std::size_t pairs = 0;
};

/// A property measured at a state point.
struct MeasuredProperty {
  RequestedProperty request;
  SeriesEstimate value;  ///< value with all corrections, in the unit of the property
  std::optional<SeriesEstimate>
      bias;  ///< time-step bias, already subtracted from the value; empty if not known
  std::optional<StepBound> step_bound;  ///< bound where no bias can be predicted: of dynamics
  std::optional<double> finite_size;    ///< finite-size correction, already included in the value
  /// Values obtained from increasing parts of the data, for figures; the last entry uses all data.
  std::vector<SeriesEstimate> stages{};
  std::string obstacle;      ///< reason why the value is not converged; empty if it is
  bool longer_helps = true;  ///< whether longer runs may remove the obstacle
  std::string remark{};      ///< where or how the value was found; empty if there is nothing to add
  /// The number of replicas that contribute, and why the others do not; empty if all contribute.
  std::string contributions{};

  /// The requested standard error in the unit of the property.
  double requested_error() const;
  bool reached() const;
  /// The interval that contains the true value with a probability; empty if the error is not known.
  /// The intervals of variances and of vapour pressures are symmetric in the logarithm, because
  /// their errors are proportional to their values. All other intervals are symmetric.
  std::optional<std::array<double, 2>> interval(double probability) const;
};

/// A function measured in the dynamics or the slab, for figures.
struct MeasuredCurve {
  std::string title, axis, unit;      ///< `axis` is the name of x with its unit
  std::vector<double> x;              ///< time lags [ps], frequencies [1/ps] or distances [nm]
  std::vector<SeriesEstimate> value;  ///< values in `unit`
};

/// A radial distribution function measured in the dynamics.
struct MeasuredDistribution {
  SitePair pair;                                 ///< names of the sites
  std::vector<double> r;                         ///< middles of the bins [nm]
  std::vector<SeriesEstimate> g;                 ///< g(r) in each bin
  std::optional<RadialDistribution::Peak> peak;  ///< first peak; empty if g(r) has none
};

/// The time series of potential energy and density of a replica, for figures of the equilibration.
struct EquilibrationTrace {
  std::vector<double> time;       ///< middles of the time intervals [ps]
  std::vector<double> potential;  ///< potential energy per molecule [kJ/mol]
  std::vector<double> density;    ///< density [kg/m³]
  double begin = 0;               ///< time at which equilibrium began [ps]
};

struct MeasuredPoint {
  StatePoint at;
  std::vector<MeasuredProperty> properties;
  std::size_t molecules = 0;
  std::uint64_t replicas = 0;
  std::string scheme{};           ///< with the sampling, in words
  double step_max = 0;            ///< largest time step of the replicas [ps]
  double equilibration_max = 0;   ///< longest discarded equilibration of a replica [ps]
  double length_of_averages = 0;  ///< total length of all replicas at constant pressure or
                                  ///< volume, without equilibration [ps]
  double length_of_dynamics = 0;  ///< total length of the dynamics of all replicas [ps]
  double length_of_coupling = 0;  ///< total length of all stages of a coupling [ps]
  double length_of_slab = 0;      ///< total length of the slabs of all replicas [ps]
  double edge = 0;  ///< box edge in the dynamics, or the mean edge at constant pressure [nm]
  std::vector<MeasuredCurve> curves;      ///< of the dynamics
  std::vector<MeasuredCurve> profiles{};  ///< density and pressures of the slab along its normal
  std::vector<MeasuredDistribution> distributions{};  ///< of centres, then of sites
  std::vector<EquilibrationTrace> traces;             ///< traces of all replicas
  /// Values for curves over state points, with the time-step bias subtracted; not known without
  /// averages, and at constant volume.
  SeriesEstimate density{std::nan("")};   ///< [kg/m³]
  SeriesEstimate enthalpy{std::nan("")};  ///< [kJ/mol]

  /// How the point was simulated: "4 replicas of 64 molecules, ..."; empty without simulations.
  /// @param line_break  what separates its two parts
  std::string conditions(const std::string& line_break = " ") const;
  /// Whether results contain the distributions, because the coordination number is requested.
  bool wants_distributions() const;
};

/// A polynomial through the densities or enthalpies of several state points.
struct StateFit {
  std::size_t points = 0, degree = 0;
  double chi_squared = 0;  ///< sum of squared deviations in standard errors
  std::size_t degrees_of_freedom() const { return points - degree - 1; }
  /// Whether the points deviate from the polynomial by much more than their errors.
  bool misfit() const;
  /// The degree with the quality of the fit: "cubic polynomial, chi2 1.2 with 3 degrees of
  /// freedom".
  std::string text() const;
};

/// The maximum of the density along temperature.
struct DensityMaximum {
  double pressure = 0;                       ///< [kJ/mol/nm³]
  SeriesEstimate temperature{std::nan("")};  ///< [K]
  SeriesEstimate density{std::nan("")};      ///< [kg/m³]
  StateFit fit;
  std::string obstacle;  ///< why it is not known; empty if it is
};

/// A property as the slope of a curve over state points, together with its value from fluctuations.
struct SlopeValue {
  const Property* property = nullptr;
  StatePoint at;
  SeriesEstimate slope;  ///< in the property's unit
  SeriesEstimate fluctuation;
  double deviation = 0;  ///< slope minus fluctuation, in standard errors of the difference
  StateFit fit;
};

struct StateCurves {
  std::vector<DensityMaximum> maxima;
  std::vector<SlopeValue> slopes;
};

/// Maxima and slopes of curves of at least three points: temperatures at one pressure, or pressures
/// at one temperature. The maximum of the density follows where `density` was requested, and a
/// slope at each point between the first and the last where its property was requested.
StateCurves state_curves(const std::vector<MeasuredPoint>& points);

/// A state point without results, and the reason: the system cannot be simulated there, or the
/// measurement ended before it.
struct MissingPoint {
  StatePoint at;
  std::string reason;
};

struct MeasureReport {
  std::vector<MeasuredPoint> points;
  std::vector<MissingPoint> missing{};
  bool failed = false;  ///< whether the system cannot be simulated at one of the missing points
  StateCurves curves;
  bool interrupted = false;  ///< whether a callback interrupted the measurement
  bool out_of_time = false;
  std::vector<std::string> files;
  std::string system;  ///< molecules of the system and their numbers, as text

  /// Whether all requested standard errors are reached, at all state points.
  bool reached() const;
};

/// A stage in which one molecule is coupled to all others.
struct CouplingStage {
  double size = 0;    ///< factor of the distances in its short-range potentials; 0: it has none
  double charge = 0;  ///< factor of its charges
  /// Estimated free energy of the next stage minus the one of this stage [kT], which makes the
  /// acceptance ratio efficient; 0 in the last stage.
  double next = 0;
  friend bool operator==(const CouplingStage&, const CouplingStage&) = default;
};

/// Stages from a molecule of an ideal gas to a molecule that is like all others.
using CouplingPath = std::vector<CouplingStage>;

/// A unit of work on a replica. Any process can do it with bitwise identical results.
struct ReplicaTask {
  std::size_t point = 0;      ///< index of the state point in the settings
  std::uint64_t replica = 0;  ///< number of the replica
  /// Numbers of segments that the replica must have after the task: of averages, dynamics, the long
  /// box of OrthoBoXY, a coupling, a slab, and dynamics with the heat flux.
  std::vector<std::size_t> segments{};
  double step = 0;       ///< time step of all replicas [ps]; 0 for a pilot, which chooses it
  std::string record{};  ///< record of the replica so far, as bytes; empty at the start
  std::vector<CouplingStage> path{};  ///< stages of the coupling; empty without one
};

/// Performs a task, and returns the updated record of the replica.
std::string perform(const MeasureSettings& settings, const ReplicaTask& task);

/// Performs tasks in any order, and returns their records in the order of the tasks.
using ReplicaExecutor =
    std::function<std::vector<std::string>(const std::vector<ReplicaTask>& tasks)>;

/// Measures properties with independent replicas. Each replica is prepared, equilibrated, and
/// simulated at constant temperature and pressure. Dynamic properties are then measured at the mean
/// volume of the replica. A state point with a density has constant volume in all of these. Lengths
/// grow by half until all requested errors are reached. Results are stored in
/// PREFIX-POINT-rN.replica. The same command resumes from these files, also if other properties,
/// errors or state points are requested.
/// @throws Error     if a requested property is not defined for the system, or records belong to
///   another system
/// @throws RunError  if a replica blows up, evaporates, separates into two phases or is a solid, at
///   all state points
/// @param executor  performs the tasks instead of the workers; may be empty
MeasureReport measure(const MeasureSettings& settings, const Callbacks& callbacks = {},
                      Workers& workers = Workers::serial(), const ReplicaExecutor& executor = {});

/// The results of a measurement as a list, from which text, JSON and the manual are made.
Quantities quantities(const MeasureReport& report);

/// The results of a measurement as a self-contained HTML page, with figures of convergence,
/// correlation functions and equilibration.
std::string measure_page(const MeasureReport& report, const std::string& command);

/// Checks that a page can be written: a file of the same name must be an earlier page.
/// @throws Error  if it is another file
void check_page(const std::string& path);

}  // namespace polhode
