// SPDX-License-Identifier: MIT
// Reads the energies that a molecular dynamics program printed over time.
#pragma once

#include <string>
#include <vector>

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

}  // namespace polhode
