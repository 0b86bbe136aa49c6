// SPDX-License-Identifier: MIT
// The energies of a run as a table that grows during the run.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "polhode/io/frame_file.hpp"
#include "polhode/io/table_file.hpp"
#include "polhode/measure/energy.hpp"
#include "polhode/model/topology.hpp"

namespace polhode {

class EnergyFile {
 public:
  /// Creates the file, replacing an existing one.
  EnergyFile(const std::string& path, const Topology& topology, const Provenance& provenance);
  /// Resumes after the rows of a mark.
  EnergyFile(const std::string& path, const Topology& topology, const FileMark& mark);

  /// Appends a row.
  /// @throws RunError  if the disk is full
  void add(const Energies& energies);
  /// Syncs all rows to disk and returns the end of the file.
  FileMark mark();

 private:
  DegreesOfFreedom degrees_of_freedom_;
  std::uint64_t rows_ = 0;
  GrowingTable table_;
};

/// Reads such a file until a mark.
/// @throws Error  if it is shorter, or holds anything else
void check_energies(const std::string& path, const FileMark& mark);

}  // namespace polhode
