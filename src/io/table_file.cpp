// SPDX-License-Identifier: MIT
#include "polhode/io/table_file.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "polhode/base/error.hpp"

namespace polhode {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

// Comments are single lines.
std::string one_line(std::string text) {
  for (char& c : text)
    if (c == '\n' || c == '\r') c = ' ';
  return text;
}

// A text with commas or quotes stands in quotes, its own doubled (RFC 4180).
std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + '"';
}

}  // namespace

Cell::Cell(double number) : text(std::isnan(number) ? "" : fmt::format("{}", number)) {}

std::string text_hash(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325;  // offset basis and prime of 64-bit FNV
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return fmt::format("{:016x}", hash);
}

void write_csv(std::ostream& out, const Table& table, const Provenance& provenance) {
  out << fmt::format("# polhode {}\n# command: {}\n# config hash: {}\n# target: {}\n# seed: {}\n",
                     provenance.version, one_line(provenance.command), text_hash(provenance.config),
                     provenance.target, provenance.seed);
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    const auto& [name, unit] = table.columns[k];
    out << (k == 0 ? "" : ",") << name;
    if (!unit.empty()) out << " [" << unit << ']';
  }
  out << '\n';
  for (const auto& row : table.rows) {
    if (row.size() != table.columns.size())
      throw std::logic_error("a row of a table has another length than its head");
    for (std::size_t k = 0; k < row.size(); ++k) out << (k == 0 ? "" : ",") << quoted(row[k].text);
    out << '\n';
  }
}

void refuse_existing(const std::string& path, bool force) {
  const fs::path folder = folder_of(path);
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw Error(fmt::format("there is no folder '{}' for the output '{}'; make it, or name another",
                            folder.string(), path));
  if (::access(folder.c_str(), W_OK) != 0)
    throw Error(
        fmt::format("the folder '{}' takes no new files ({}); name another for the output "
                    "'{}'",
                    folder.string(), std::strerror(errno), path));
  if (fs::is_directory(path, error))
    throw Error(fmt::format("'{}' is a folder; the output must be a file, so name another", path));
  if (!force && fs::exists(path, error))
    throw Error(
        fmt::format("'{}' is there already and would be overwritten; name another output, "
                    "or give --force",
                    path));
}

void write_file(const std::string& path, const std::function<void(std::ostream&)>& write) {
  const std::string temporary = fmt::format("{}.{}.part", path, ::getpid());
  const auto refuse = [&](const std::string& why) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw Error(
        fmt::format("'{}' cannot be written ({}); name another output, or make room", path, why));
  };
  std::ofstream out(temporary, std::ios::binary);
  if (!out) refuse(std::strerror(errno));
  try {
    write(out);
  } catch (...) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw;
  }
  out.close();
  if (!out) refuse(std::strerror(errno));
  std::error_code error;
  fs::rename(temporary, path, error);
  if (error) refuse(error.message());
}

}  // namespace polhode
