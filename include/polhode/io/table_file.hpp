// SPDX-License-Identifier: MIT
// Tables of results: CSV with a head of comments that says what made them, written whole or not at
// all.
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
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

/// Throws if the file is there and `force` is not given, or if its folder cannot be written to;
/// call it before anything is computed.
void refuse_existing(const std::string& path, bool force);

/// Writes a file whole or not at all: into a temporary one beside it, which then takes its name.
/// @throws Error  if that cannot be done
void write_file(const std::string& path, const std::function<void(std::ostream&)>& write);

}  // namespace polhode
