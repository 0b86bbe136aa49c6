// SPDX-License-Identifier: MIT
// Reads the energies that a molecular dynamics program printed over time, and computes the
// time-step bias of averages from them (docs/theory.md, Eqs. (47) and (51)).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "polhode/measure/correlated_series.hpp"
#include "polhode/measure/slope.hpp"
#include "polhode/run/quantities.hpp"
#include "run/given.hpp"

namespace polhode {

/// A quantity of a log over time.
struct LogColumn {
  std::string name, unit;  ///< name and unit as in the log; the unit is empty if the log has none
  std::vector<double> values;
};

/// The columns of a log, all of the same length.
struct EngineLog {
  std::string file;    ///< name for error messages
  std::string format;  ///< "LAMMPS log", "xvg file" or "CSV file"
  std::vector<LogColumn> columns;
  double divisor = 1;  ///< number by which energies were divided, such as the number of atoms
  std::vector<std::string> notes;  ///< choices of the reader, such as the run that is used

  std::size_t samples() const { return columns.empty() ? 0 : columns.front().values.size(); }
  /// The first column with one of these names, in any letter case; null if there is none.
  const LogColumn* find(const std::vector<std::string>& names) const;
  /// The column with this name, or with this name and unit, as in "total [kJ/mol]"; null if there
  /// is none.
  const LogColumn* titled(const std::string& title) const;
};

/// A column without values, from a title such as "Total Energy (kJ/mole)", "total [kJ/mol]" or
/// "LJ (SR) (kJ/mol)". OpenMM's first title has a # and quotation marks.
LogColumn titled_column(const std::string& title);

/// Reads a log. The contents determine the format:
/// - a log of LAMMPS with thermo output in lines; the last of several runs is used;
/// - an .xvg file of `gmx energy`, with its legends;
/// - a CSV file with the column names in its first line, as written by OpenMM's StateDataReporter
///   or by polhode.
/// @throws Error  if the file has none of these formats, or a row is incomplete
EngineLog read_engine_log(const std::string& path);

/// Reads a log from a text; `file` is its name in error messages.
EngineLog parse_engine_log(const std::string& text, const std::string& file);

/// A log of columns that are in memory.
/// @param titles  names of the columns, with units in brackets, such as "Total Energy (kJ/mol)"
/// @throws Error  if the columns have different lengths, or contain values that are not finite
EngineLog log_of_columns(const std::string& name, const std::vector<std::string>& titles,
                         const std::vector<std::vector<double>>& columns);

/// The options that a front end received for the bias of a log, as texts.
struct BiasRequest {
  Given total, potential, temperature, energy_unit, start, stop;

  static std::vector<RequestOption<BiasRequest>> options();
};

/// A column of the log with its mean and time-step bias.
struct ColumnBias {
  std::string name, unit;
  SeriesEstimate mean;       ///< mean of the log
  SeriesEstimate bias;       ///< time-step bias of the mean at constant energy
  SeriesEstimate corrected;  ///< mean without the bias
};

/// The time-step bias of all averages of a log.
struct LogBias {
  std::string format, energy_unit;
  std::string energy;     ///< column of the energy that exact dynamics conserves
  bool has_bath = false;  ///< whether the run had a thermostat
  std::size_t samples = 0;
  double temperature = 0;  ///< temperature of kT [K], or in units of the well depth
  double R = 0;  ///< fluctuation of the total energy over the fluctuation of the potential energy
  double resolution = 0;       ///< smallest difference between printed total energies
  SeriesEstimate fluctuation;  ///< standard deviation of the total energy about its linear fit
  Drift drift;                 ///< drift of the total energy per time, or per sample without times
  std::vector<ColumnBias> columns;
  /// Time-step bias of the potential energy at constant temperature, with a slow rescaling or
  /// Nosé-Hoover thermostat, Eq. (51); empty without potential energies.
  std::optional<SeriesEstimate> at_constant_temperature;
  std::vector<std::string> notes, warnings;
};

/// Computes the time-step bias of all averages of a log.
/// @throws Error  if the total energy or the temperature is missing, if the energy was not
///   constant, or if the energies have too few digits
LogBias log_bias(const EngineLog& log, const BiasRequest& request);

Quantities quantities(const LogBias& bias);

}  // namespace polhode
