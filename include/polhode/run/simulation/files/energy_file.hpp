// SPDX-License-Identifier: MIT
// The energies of a run as a table that grows during the run.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "polhode/io/coordinates/frame_file.hpp"
#include "polhode/io/files/table_file.hpp"
#include "polhode/measure/energy.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

/// The columns of an energies file; the last column exists only with step errors.
std::vector<Table::Column> energy_columns(bool step_errors);
std::array<double, 15> energy_row(const Energies& energies,
                                  const DegreesOfFreedom& degrees_of_freedom);

class EnergyFile {
 public:
  /// Creates the energies file, and replaces an existing file.
  /// @param step_errors  whether the file has a column for time-step errors
  EnergyFile(const std::string& path, const Topology& topology, bool step_errors,
             const Provenance& provenance);
  /// Resumes the energies file after the rows of a mark.
  EnergyFile(const std::string& path, const Topology& topology, bool step_errors,
             const FileMark& mark);

  /// Appends a row of energies.
  /// @throws RunError  if the disk is full
  void add(const Energies& energies);
  /// Syncs all rows to disk and returns the end of the file.
  FileMark mark();

 private:
  DegreesOfFreedom degrees_of_freedom_;
  bool step_errors_;
  std::uint64_t rows_ = 0;
  GrowingTable table_;
};

/// A row of an energies file.
struct EnergyRow {
  Energies energies;
  double conserved = 0;  ///< conserved energy [kJ/mol]; heat and work have no columns
};

/// Reads an energies file row by row, with or without step errors.
class EnergyReader {
 public:
  /// @throws Error  if the file cannot be read, or has different columns
  explicit EnergyReader(const std::string& path);
  /// Reads the next row. The result is empty at the end of the file.
  /// @throws Error  if a row is not complete
  std::optional<EnergyRow> next();

 private:
  TableReader table_;
  std::vector<double> row_;
};

/// Checks an energies file up to a mark.
/// @throws Error  if the file is shorter, or has different contents
void check_energies(const std::string& path, bool step_errors, const FileMark& mark);

}  // namespace polhode
