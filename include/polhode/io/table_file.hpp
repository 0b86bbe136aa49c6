// SPDX-License-Identifier: MIT
// Tables of results: CSV with a head of comments that says what made them, written whole or not at
// all, or growing row by row.
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

namespace polhode {

/// What made an output; the same lines begin every file.
struct Provenance {
  std::string version;  ///< of the program
  std::string command;  ///< as typed
  std::string config;   ///< text of the run file
  std::string target;   ///< instruction set
  std::uint64_t seed = 0;
};

/// Stable 64-bit hash of a text, 16 hexadecimal digits (FNV-1a).
std::string text_hash(std::string_view text);

/// One field: a number, with as many digits as give the same double again, or a name.
struct Cell {
  std::string text;
  Cell(double number);  // implicit, as rows mix both
  Cell(std::string name) : text(std::move(name)) {}
  Cell(const char* name) : text(name) {}
};

struct Table {
  struct Column {
    std::string name;
    std::string unit;  ///< "1" for pure numbers; empty for names
  };
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;
};

/// CSV: "# " lines of provenance, a line "time [ps],potential [kJ/mol]", then the rows.
/// Not-a-number is an empty field.
void write_csv(std::ostream& out, const Table& table, const Provenance& provenance);

/// A CSV file that grows row by row.
class GrowingTable {
 public:
  /// Begins the file; what was there is lost.
  /// @throws Error  if it cannot be written
  GrowingTable(const std::string& path, const std::vector<Table::Column>& columns,
               const Provenance& provenance);
  /// Goes on with a file after its first bytes; what follows them is cut off.
  /// @throws Error  if the file is shorter, or cannot be written
  GrowingTable(const std::string& path, std::uint64_t bytes);

  /// @throws RunError  if the file cannot be written to its end
  void add(std::span<const double> row);
  /// Hands all rows to the disk and tells how long the file is.
  /// @throws RunError  as add()
  std::uint64_t mark();

 private:
  void check();
  std::string path_;
  std::ofstream out_;
};

/// Calls visit(row) for the rows of numbers within the first bytes of a table. Numbers that were
/// written come back with all their bits.
/// @throws Error  if the file is shorter, has other columns, or a row is not whole
void each_row(const std::string& path, std::uint64_t bytes,
              const std::vector<Table::Column>& columns,
              const std::function<void(std::span<const double>)>& visit);

/// Throws if the file is there and `force` is not given, or if its folder cannot be written to;
/// call it before anything is computed.
void refuse_existing(const std::string& path, bool force);

/// Writes a file whole or not at all: into a temporary one beside it, which takes its name once it
/// is on the disk.
/// @param keep  name that what was there takes; without it, it is lost
/// @throws Error  if that cannot be done
void write_file(const std::string& path, const std::function<void(std::ostream&)>& write,
                const std::string& keep = {});

}  // namespace polhode
