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

/// The columns that only some energies files have.
struct EnergyColumns {
  bool step_errors = false;      ///< time-step errors, in the last column
  bool pressure_tensor = false;  ///< six components of the pressure tensor, after the volume
};

/// The columns of an energies file.
std::vector<Table::Column> energy_columns(EnergyColumns with = {});
/// The numbers of all columns except for the pressure tensor.
std::array<double, 15> energy_row(const Energies& energies,
                                  const DegreesOfFreedom& degrees_of_freedom);

class EnergyFile {
 public:
  /// Creates the energies file, and replaces an existing file.
  EnergyFile(const std::string& path, const Topology& topology, EnergyColumns with,
             const Provenance& provenance);
  /// Resumes the energies file after a mark; later rows are removed.
  EnergyFile(const std::string& path, const Topology& topology, EnergyColumns with,
             const FileMark& mark);

  /// Appends a row of energies.
  /// @param pressure_tensor  pressure tensor [kJ/mol/nm³], if the file has columns for it
  /// @throws RunError  if the disk is full
  void add(const Energies& energies, const Mat3<double>& pressure_tensor = {});
  /// Syncs all rows to disk and returns the end of the file.
  FileMark mark();

 private:
  DegreesOfFreedom degrees_of_freedom_;
  EnergyColumns with_;
  std::uint64_t rows_ = 0;
  GrowingTable table_;
};

/// A row of an energies file.
struct EnergyRow {
  Energies energies;
  double conserved = 0;  ///< conserved energy [kJ/mol]; heat and work have no columns
};

/// Reads an energies file row by row, with any columns.
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
void check_energies(const std::string& path, EnergyColumns with, const FileMark& mark);

}  // namespace polhode
