// SPDX-License-Identifier: MIT
#include "polhode/io/files/table_file.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "base/from_chars.hpp"
#include "base/output_error.hpp"
#include "base/printable.hpp"
#include "io/files/checksum.hpp"
#include "io/files/disk.hpp"
#include "io/files/draft.hpp"
#include "io/files/write_file.hpp"

namespace polhode {
namespace {

namespace fs = std::filesystem;

// A text with commas or quotes is quoted, and its quotes are doubled (RFC 4180).
std::string quote_field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + '"';
}

std::string head_of(const std::vector<Table::Column>& columns) {
  std::string line;
  for (const auto& [name, unit] : columns) {
    if (!line.empty()) line += ',';
    line += quote_field(unit.empty() ? name : fmt::format("{} [{}]", name, unit));
  }
  return line;
}

void write_head(std::ostream& out, const std::vector<Table::Column>& columns,
                const Provenance& provenance) {
  out << head_of(columns) << '\n'
      << fmt::format(
             "# polhode {}\n# command: {}\n# config hash: {}\n# instruction set: {}\n# seed: {}\n",
             provenance.version, printable(provenance.command), text_hash(provenance.config),
             provenance.instruction_set, provenance.seed);
}

/// Rejects a line of a table.
[[noreturn]] void refuse_line(const std::string& path, std::size_t number,
                              const std::string& what) {
  throw Error(what, fmt::format("{}:{}", path, number));
}

void check_head(const std::string& path, std::size_t number, const std::string& line,
                const std::vector<Table::Column>& columns) {
  if (const std::string head = head_of(columns); line != head)
    refuse_line(
        path, number,
        fmt::format("the table has the columns '{}'; it must have the columns '{}'", line, head));
}

/// Reads the numbers of a line.
void read_row(const std::string& path, std::size_t number, const std::string& line,
              std::size_t columns, std::vector<double>& row) {
  row.clear();
  for (const char *at = line.data(), *const end = at + line.size(); at <= end; ++at) {
    double value = std::numeric_limits<double>::quiet_NaN();
    const auto [next, status] = from_chars(at, end, value);
    if (next != end && *next != ',')
      refuse_line(path, number, fmt::format("'{}' is not a row of numbers", line));
    row.push_back(value);
    at = next;
  }
  if (row.size() != columns)
    refuse_line(path, number,
                fmt::format("the row has {} numbers; it must have {}", row.size(), columns));
}

}  // namespace

Cell::Cell(double number) : text(std::isnan(number) ? "" : fmt::format("{}", number)) {}

std::string text_hash(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325;  // offset basis and prime of 64-bit FNV
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return fmt::format("{:016x}", hash);
}

void write_csv(std::ostream& out, const Table& table, const Provenance& provenance) {
  write_head(out, table.columns, provenance);
  for (const auto& row : table.rows) {
    if (row.size() != table.columns.size())
      throw std::logic_error("a row of a table differs in length from its header");
    for (std::size_t k = 0; k < row.size(); ++k)
      out << (k == 0 ? "" : ",") << quote_field(row[k].text);
    out << '\n';
  }
}

GrowingTable::GrowingTable(const std::string& path, const std::vector<Table::Column>& columns,
                           const Provenance& provenance)
    : path_(path) {
  remove_output(path);
  out_.open(path, std::ios::binary);
  if (!out_) throw Error(cannot_write(path, errno));
  held_.hold(path);
  write_head(out_, columns, provenance);
}

GrowingTable::GrowingTable(const std::string& path, const TableMark& mark)
    : path_(path), mark_(mark) {
  held_.hold(path);
  cut_file(path, mark.bytes);
  out_.open(path, std::ios::binary | std::ios::app | std::ios::ate);
  if (!out_) throw Error(cannot_write(path, errno));
}

void GrowingTable::add(std::span<const double> row) {
  for (std::size_t k = 0; k < row.size(); ++k) out_ << (k == 0 ? "" : ",") << Cell(row[k]).text;
  out_ << '\n';
  check();
}

TableMark GrowingTable::mark() {
  out_.flush();
  check();
  sync_file(path_);
  const auto bytes = static_cast<std::uint64_t>(out_.tellp());
  mark_ = {bytes, file_crc64(path_, mark_.bytes, bytes, mark_.checksum)};
  return mark_;
}

void GrowingTable::check() {
  if (!out_) throw RunError("'" + path_ + "' could not be written completely; is the disk full?");
}

TableReader::TableReader(const std::string& path,
                         std::span<const std::vector<Table::Column>> columns)
    : path_(path), in_(path, std::ios::binary) {
  std::string line;
  if (!in_ || !std::getline(in_, line))
    throw Error(fmt::format("'{}' cannot be read ({}); check its name and permissions", path,
                            in_.is_open() ? "it is empty" : std::strerror(errno)));
  ++line_;
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [&](const auto& one) { return line == head_of(one); });
  if (found == columns.end()) check_head(path, line_, line, columns.front());
  columns_ = found->size();
}

bool TableReader::next(std::vector<double>& row) {
  std::string line;
  do {
    if (!std::getline(in_, line)) return false;
    ++line_;
  } while (line.starts_with('#'));
  if (in_.eof())
    refuse_line(path_, line_,
                "the last row has no end of line, so this row may be incomplete; delete the row, "
                "or wait until the run that writes the file has ended");
  read_row(path_, line_, line, columns_, row);
  return true;
}

void each_row(const std::string& path, std::uint64_t bytes,
              const std::vector<Table::Column>& columns,
              const std::function<void(std::span<const double>)>& visit) {
  check_length(path, bytes);
  std::ifstream in(path, std::ios::binary);
  std::string line;
  std::vector<double> row;
  bool started = false;
  std::uint64_t read = 0;
  for (std::size_t number = 1; read < bytes; ++number) {
    if (!std::getline(in, line))
      throw Error("'" + path + "' cannot be read; check its permissions");
    read += line.size() + 1;
    if (line.starts_with('#')) continue;
    if (!started) {
      check_head(path, number, line, columns);
      started = true;
      continue;
    }
    read_row(path, number, line, columns.size(), row);
    visit(row);
  }
  if (read != bytes)
    throw Error(fmt::format(
        "'{}' has no end of line at byte {}, where the table ended when the checkpoint was written",
        path, bytes));
}

void refuse_existing(const std::string& path, bool force) {
  check_name("the output", path);
  check_folder(path);
  check_length_of_name(path);
  std::error_code error;
  if (fs::is_directory(path, error))
    throw Error(
        fmt::format("'{}' is a folder, but the output must be a file; give another output", path));
  const fs::file_status found = fs::symlink_status(path, error);
  if (fs::is_other(found))
    throw Error(fmt::format(
        "'{}' is a device, a pipe or a socket, but the output must be a file; give another output",
        path));
  if (force || !fs::exists(found)) return;
  if (fs::is_symlink(found))
    throw OutputError(
        fmt::format("'{}' is a symbolic link to '{}'; the output would replace the link instead of "
                    "its target: give an output in the folder of the target, or delete the link",
                    path, fs::read_symlink(path, error).string()));
  throw OutputError(fmt::format(
      "'{}' exists and would be overwritten; give another output, or delete the file", path));
}

void write_file(const std::string& path, const std::function<void(std::ostream&)>& write,
                const std::string& keep) {
  const auto refuse = [&] { throw RunError(cannot_write(path, errno)); };
  try {
    Draft draft(path);
    std::ofstream out(draft.path(), std::ios::binary);
    if (!out) refuse();
    write(out);
    out.close();
    if (!out) refuse();
    draft.finish(keep);
  } catch (const Error& e) {  // the computation is complete, so the input was valid
    throw RunError(e.what());
  }
}

}  // namespace polhode
