// SPDX-License-Identifier: MIT
// Tables of results in CSV files. Comments in the files give the provenance of the results.
#pragma once

#include <cstdint>
#include <fstream>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "polhode/io/files/file_lock.hpp"

namespace polhode {

/// The origin of an output file: the program, command and settings that made it. Every output file
/// begins with these data.
struct Provenance {
  std::string version;          ///< version of the program
  std::string command;          ///< command as the user typed it
  std::string config;           ///< text of the run file
  std::string instruction_set;  ///< instruction set
  std::uint64_t seed = 0;
};

/// One field of a table: a name, or a number with enough digits to reproduce the double exactly.
struct Cell {
  std::string text;
  Cell(double number);  // implicit, because rows mix names and numbers
  Cell(std::string name) : text(std::move(name)) {}
  Cell(const char* name) : text(name) {}
};

struct Table {
  struct Column {
    std::string name;
    std::string unit;  ///< "1" for dimensionless numbers; empty for columns of names
  };
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;
};

/// Position at the end of a growing table, from which the table can be resumed.
struct TableMark {
  std::uint64_t bytes = 0;     ///< length of the file
  std::uint64_t checksum = 0;  ///< CRC-64 of the file up to this position
};

/// A CSV file that grows row by row.
class GrowingTable {
 public:
  /// Creates the file and replaces an existing one. A symbolic link is replaced, but not its
  /// target.
  /// @throws Error  if the file cannot be written
  GrowingTable(const std::string& path, const std::vector<Table::Column>& columns,
               const Provenance& provenance);
  /// Resumes a file after a mark; anything after the mark is removed.
  /// @throws Error  if the file is shorter than the mark, cannot be written, or is being written by
  ///   another process
  GrowingTable(const std::string& path, const TableMark& mark);

  /// Appends a row.
  /// @throws RunError  if the row cannot be written completely
  void add(std::span<const double> row);
  /// Syncs all rows to disk and returns the end of the file.
  /// @throws RunError  if the rows cannot be written completely
  TableMark mark();

 private:
  void check();
  std::string path_;
  HeldFile held_;
  std::ofstream out_;
  TableMark mark_;
};

/// Reads a table of numbers row by row; empty fields are NaN. Numbers are read back exactly as they
/// were written.
class TableReader {
 public:
  /// @param columns  possible lists of columns
  /// @throws Error  if the file cannot be read, or has different columns
  TableReader(const std::string& path, std::span<const std::vector<Table::Column>> columns);
  /// Reads the next row. Returns false at the end of the file.
  /// @throws Error  if a row is not complete
  bool next(std::vector<double>& row);

 private:
  std::string path_;
  std::ifstream in_;
  std::size_t columns_, line_ = 0;
};

}  // namespace polhode
