// SPDX-License-Identifier: MIT
// Tables of results: CSV files with comments that tell how they were made, written
// atomically, or row by row.
#pragma once

#include <cstdint>
#include <fstream>
#include <functional>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "polhode/io/files/file_lock.hpp"

namespace polhode {

/// How an output was made; the same lines begin every file.
struct Provenance {
  std::string version;          ///< version of the program
  std::string command;          ///< command as typed
  std::string config;           ///< text of the run file
  std::string instruction_set;  ///< instruction set
  std::uint64_t seed = 0;
};

/// Stable 64-bit hash of a text, 16 hexadecimal digits (FNV-1a).
std::string text_hash(std::string_view text);

/// One field: a name, or a number with enough digits to reproduce the double exactly.
struct Cell {
  std::string text;
  Cell(double number);  // implicit, since rows mix both
  Cell(std::string name) : text(std::move(name)) {}
  Cell(const char* name) : text(name) {}
};

struct Table {
  struct Column {
    std::string name;
    std::string unit;  ///< "1" for dimensionless numbers; empty for names
  };
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;
};

/// CSV: a line "time [ps],potential [kJ/mol]", "# " lines of provenance, then the rows. NaN is
/// written as an empty field. The names come first, because numpy reads them from the first line,
/// even from a comment.
void write_csv(std::ostream& out, const Table& table, const Provenance& provenance);

/// Position at the end of a growing table.
struct TableMark {
  std::uint64_t bytes = 0;     ///< length of the file
  std::uint64_t checksum = 0;  ///< CRC-64 of them
};

/// A CSV file that grows row by row.
class GrowingTable {
 public:
  /// Creates the file, replacing an existing one; a link is replaced, not its target.
  /// @throws Error  if it cannot be written
  GrowingTable(const std::string& path, const std::vector<Table::Column>& columns,
               const Provenance& provenance);
  /// Resumes a file after a mark; what follows it is removed.
  /// @throws Error  if the file is shorter, cannot be written, or is being written by another
  ///                process
  GrowingTable(const std::string& path, const TableMark& mark);

  /// @throws RunError  if the row cannot be written completely
  void add(std::span<const double> row);
  /// Syncs all rows to disk and returns the end of the file.
  /// @throws RunError  as add()
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
  /// @param columns  of which the last may be missing
  /// @throws Error  if the file cannot be read, or has other columns
  TableReader(const std::string& path, const std::vector<Table::Column>& columns);
  /// Reads the next row; false at the end of the file.
  /// @throws Error  if a row is not complete
  bool next(std::vector<double>& row);

 private:
  std::string path_;
  std::ifstream in_;
  std::size_t columns_, line_ = 0;
};

/// Calls visit(row) for the rows of numbers within the first bytes of a table. Numbers are read
/// back exactly as they were written.
/// @throws Error  if the file is shorter, has other columns, or contains an incomplete row
void each_row(const std::string& path, std::uint64_t bytes,
              const std::vector<Table::Column>& columns,
              const std::function<void(std::span<const double>)>& visit);

/// Throws if the file exists and `force` is not given, or if it is a folder or a device. Also
/// throws if its folder cannot be written to, or if its name is too long, has control characters or
/// is not UTF-8. Call it before anything is computed. A symbolic link exists, whatever its target.
/// With `force` the link is replaced, and its target stays.
void refuse_existing(const std::string& path, bool force);

/// Writes a file completely or not at all (io/draft.hpp).
/// @param keep  new name for an existing file; if empty, that file is replaced
/// @throws RunError  if that cannot be done
void write_file(const std::string& path, const std::function<void(std::ostream&)>& write,
                const std::string& keep = {});

}  // namespace polhode
