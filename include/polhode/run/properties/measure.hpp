// SPDX-License-Identifier: MIT
// Measures properties of a model at state points, each to a requested error.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "polhode/base/workers.hpp"
#include "polhode/io/settings/config.hpp"
#include "polhode/measure/correlated_series.hpp"
#include "polhode/run/callbacks.hpp"
#include "polhode/run/outputs.hpp"
#include "polhode/run/quantities.hpp"

namespace polhode {

/// A row of the properties that can be measured, with its definition.
struct Property;

/// A state at which properties are measured.
struct StatePoint {
  double temperature = 0;  ///< [K]
  double pressure = 0;     ///< [kJ/mol/nm³]

  /// "298.15 K, 1 bar".
  std::string text() const;
  /// "298.15K-1bar", for file names.
  std::string file_text() const;
};

struct RequestedProperty {
  const Property* property = nullptr;
  double error = 0.01;   ///< standard error that is requested
  bool relative = true;  ///< of the value, otherwise in the property's unit
};

/// Replicas that a process computes: those whose number is `index` modulo `count`.
struct Shard {
  std::uint64_t index = 0, count = 1;
};

struct MeasureSettings {
  Config config;  ///< molecules, forces and seed
  std::vector<StatePoint> points;
  std::vector<RequestedProperty> properties;
  std::uint64_t replicas = 4;  ///< independent simulations of each state point
  Shard shard{};
  double time_limit = 0;  ///< of wall-clock time [s]; 0: none
  std::string prefix = "measure";
  std::string command = "polhode measure";  ///< for the record
  bool only_evaluate = false;               ///< reports what the records have, and computes nothing
};

/// A property at a state point.
struct MeasuredProperty {
  RequestedProperty request;
  SeriesEstimate value;                ///< with all corrections, in the property's unit
  std::optional<SeriesEstimate> bias;  ///< time-step bias, which is subtracted; nothing: not known
  std::optional<double> finite_size;   ///< finite-size correction, which is included
  /// What the value was from the first parts of the data, for figures; the last is all of it.
  std::vector<SeriesEstimate> stages{};
  std::string obstacle;  ///< why the value is not converged; empty if it is

  /// The requested standard error in the property's unit.
  double requested_error() const;
  bool reached() const;
};

/// A correlation function of the dynamics, for figures.
struct MeasuredCurve {
  std::string title, unit;
  std::vector<double> time;           ///< [ps]
  std::vector<SeriesEstimate> value;  ///< in `unit`
};

/// The potential energy and the density of a replica along its averages, and where equilibrium
/// began.
struct EquilibrationTrace {
  std::vector<double> time;       ///< middles of the parts [ps]
  std::vector<double> potential;  ///< per molecule [kJ/mol]
  std::vector<double> density;    ///< [kg/m³]
  double begin = 0;               ///< of equilibrium [ps]
};

struct MeasuredPoint {
  StatePoint at;
  std::vector<MeasuredProperty> properties;
  std::size_t molecules = 0;
  std::uint64_t replicas = 0;
  double step_min = 0, step_max = 0;  ///< of the replicas [ps]
  double equilibration_max = 0;       ///< that was discarded, the maximum of all replicas [ps]
  double length_of_averages = 0;      ///< of all replicas, without equilibration [ps]
  double length_of_dynamics = 0;      ///< of all replicas [ps]
  double edge = 0;                    ///< of the box of the dynamics, or the mean one [nm]
  std::vector<MeasuredCurve> curves;
  std::vector<EquilibrationTrace> traces;  ///< of all replicas
};

struct MeasureReport {
  std::vector<MeasuredPoint> points;
  bool interrupted = false;  ///< by the callbacks
  bool out_of_time = false;
  std::vector<std::string> files;
  std::string system;  ///< the molecules and their numbers

  /// Whether all requested errors are reached.
  bool reached() const;
};

/// Work on a replica that can be done in any process: its bits do not depend on where.
struct ReplicaTask {
  std::size_t point = 0;                   ///< of the settings
  std::uint64_t replica = 0;               ///< its number
  std::size_t averages = 0, dynamics = 0;  ///< segments that it shall have
  double step = 0;     ///< time step of all replicas [ps]; 0: of a pilot, which chooses it
  std::string record;  ///< what it has computed so far, as bytes; empty: nothing
};

/// The record of the replica afterwards.
std::string perform(const MeasureSettings& settings, const ReplicaTask& task);

/// Performs tasks in any order, and returns their records in the order of the tasks.
using ReplicaExecutor =
    std::function<std::vector<std::string>(const std::vector<ReplicaTask>& tasks)>;

/// Measures with replicas. Each is prepared, equilibrated and simulated at constant temperature and
/// pressure, then for dynamics at its mean volume. Lengths grow by half until all requested errors
/// are reached. Results are kept in PREFIX-POINT-rN.replica, from which the same command resumes,
/// also with other properties, errors or points.
/// @throws Error     if a system has not one of the properties, or records are of another system
/// @throws RunError  if a replica blows up or evaporates
/// @param executor  performs the tasks in place of the workers, if there is one
MeasureReport measure(const MeasureSettings& settings, const Callbacks& callbacks = {},
                      Workers& workers = Workers::serial(), const ReplicaExecutor& executor = {});

/// The results as a list, from which text, JSON and the manual follow.
Quantities quantities(const MeasureReport& report);

/// The results as a page of HTML that needs no other file, with figures of convergence, correlation
/// functions and equilibration.
std::string measure_page(const MeasureReport& report, const std::string& command);

}  // namespace polhode
