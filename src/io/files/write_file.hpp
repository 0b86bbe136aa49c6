// SPDX-License-Identifier: MIT
// Writes and reads whole files.
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "polhode/io/files/table_file.hpp"

namespace polhode {

/// A stable 64-bit hash of a text as 16 hexadecimal digits (FNV-1a).
std::string text_hash(std::string_view text);

/// Writes a table as CSV. The first line contains column names such as "time [ps],potential
/// [kJ/mol]". The first line is followed by provenance lines, which begin with "# ", and by the
/// rows. NaN is written as an empty field. Column names are on the first line, because numpy reads
/// column names only from the first line.
void write_csv(std::ostream& out, const Table& table, const Provenance& provenance);

/// Calls visit(row) for each row of numbers within the first `bytes` bytes of a table. Numbers are
/// read back exactly as they were written.
/// @throws Error  if the file is shorter, has different columns, or contains an incomplete row
void each_row(const std::string& path, std::uint64_t bytes,
              const std::vector<Table::Column>& columns,
              const std::function<void(std::span<const double>)>& visit);

/// Throws an Error if a file exists and `force` is false, or if the path is a folder or a device.
/// An Error is also thrown if the folder cannot be written to, or if the name is too long, has
/// control characters or is not UTF-8. Call this function before anything is computed. A symbolic
/// link is treated as an existing file, even if its target does not exist. With `force` a symbolic
/// link is replaced, and its target is left unchanged.
void refuse_existing(const std::string& path, bool force);

/// Writes a file completely or not at all (io/files/draft.hpp).
/// @param keep  new name for an existing file; if empty, the existing file is replaced
/// @throws RunError  if the file cannot be written or renamed
void write_file(const std::string& path, const std::function<void(std::ostream&)>& write,
                const std::string& keep = {});

}  // namespace polhode
