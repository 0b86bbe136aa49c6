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

  /// Appends a row, and replaces the energies by what will be read back: only the last digit of the
  /// pressure changes, because the file has it in bar.
  /// @throws RunError  if the disk is full
  void add(Energies& energies);
  /// Syncs all rows to disk, and returns the position in the file.
  FileMark mark() { return {rows_, table_.mark()}; }

 private:
  Freedoms freedoms_;
  std::uint64_t rows_ = 0;
  GrowingTable table_;
};

/// The energies in such a file up to a mark.
/// @throws Error  if it is shorter, or is not such a file
std::vector<Energies> read_energies(const std::string& path, const FileMark& mark);

}  // namespace polhode
