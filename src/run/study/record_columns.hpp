// SPDX-License-Identifier: MIT
// Records of runs as text. The first line identifies the study. Each further line is a record, with
// fields separated by semicolons. Each column is defined once, for both writing and reading.
#pragma once

#include <fmt/core.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "base/output_error.hpp"
#include "io/files/write_file.hpp"
#include "io/formats/lines.hpp"
#include "run/study/run_record.hpp"

namespace polhode {

/// The fields of one line of a record.
class RecordFields {
 public:
  /// @throws Error  with the line, unless the line has `count` fields; errors of the members also
  ///   give the line
  RecordFields(std::string_view line, std::size_t count, const Lines& lines);

  std::string_view operator[](std::size_t k) const { return field_[k]; }
  double number(std::size_t k, const char* what) const;  ///< field k as a finite number
  double amount(std::size_t k,
                const char* what) const;             ///< field k as a number that is not negative
  int index(std::size_t k, const char* what) const;  ///< field k as an integer of 0 or more
  bool yes(std::size_t k, const char* what) const;   ///< field k as a flag, 1 or 0

  [[noreturn]] void refuse(const std::string& what) const;

 private:
  std::vector<std::string_view> field_;
  const Lines& lines_;
};

/// The first line of the record of a study.
std::string identity_line(const Provenance& provenance);

/// Visits the lines of a record. An incomplete last line, left by an interruption, is ignored.
/// @param provenance  provenance of the study to which the record must belong; null for any study
/// @param columns     function that returns the number of fields of a line, from the line with the
///   names of the columns
void read_record(
    std::istream& in, const std::string& path, const Provenance* provenance,
    const std::function<std::size_t(std::string_view head, const Lines& lines)>& columns,
    const std::function<void(const RecordFields& fields, std::size_t count)>& visit);

/// A column of a record, after the columns of scheme, step, initial configuration and stability.
template <class Run>
struct RecordColumn {
  std::string head;                                        ///< name of the column with its unit
  std::string name;                                        ///< name of the column in error messages
  std::function<std::optional<double>(const Run&)> value;  ///< value of the column; empty for an
                                                           ///< empty field
  std::function<void(Run&, double)> set;  ///< function that sets the value; its argument is NaN for
                                          ///< an empty field
  bool has_sign = false;                  ///< whether negative values are valid
  bool always = false;                    ///< whether the value is also known for a
                                          ///< run that blew up
  /// Whether the column has no number in a given line.
  std::function<bool(const RecordFields&, std::size_t)> absent = {};
};

inline constexpr std::size_t first_column = 4;
inline bool empty_field(const RecordFields& line, std::size_t k) { return line[k].empty(); }

/// A column for a member of Run.
template <class Run>
RecordColumn<Run> column_of(std::string head, std::string name, double Run::*member) {
  return {std::move(head), std::move(name), [member](const Run& run) { return run.*member; },
          [member](Run& run, double value) { run.*member = value; }};
}

/// The columns in the run records of a kind of study.
template <class Run>
const std::vector<RecordColumn<Run>>& record_columns();

/// The line with the names of the columns.
template <class Run>
std::string record_head() {
  std::string head = "scheme;step [ps];start;stable";
  for (const auto& column : record_columns<Run>()) head += ";" + column.head;
  return head;
}

/// The number of fields of a line, found from the line with the column names.
template <class Run>
std::size_t field_count(std::string_view head, const Lines& lines);

template <class Run>
std::string record_line(const Run& run) {
  std::string line =
      fmt::format("{};{:.17g};{};{}", run.scheme, run.step, run.start, run.stable ? 1 : 0);
  for (const auto& column : record_columns<Run>()) {
    const std::optional<double> value = column.value(run);
    line += value ? fmt::format(";{:.17g}", *value) : ";";
  }
  return line;
}

template <class Run>
Run record_run(const RecordFields& line, std::size_t count) {
  Run run{.scheme = std::string(line[0]),
          .step = line.amount(1, "step"),
          .start = line.index(2, "start"),
          .stable = line.yes(3, "'stable'")};
  std::size_t k = first_column;
  for (const auto& column : record_columns<Run>()) {
    if (k == count) break;
    const char* name = column.name.c_str();
    if (run.stable || column.always)
      column.set(run, column.absent && column.absent(line, k) ? std::nan("")
                      : column.has_sign                       ? line.number(k, name)
                                                              : line.amount(k, name));
    ++k;
  }
  return run;
}

template <class Run>
std::vector<Run> RunRecord<Run>::read(std::istream& in, const std::string& path,
                                      const Provenance* provenance) {
  std::vector<Run> runs;
  std::set<std::tuple<std::string, double, int>> met;  // runs already read, by scheme, step and
                                                       // initial configuration
  read_record(
      in, path, provenance, field_count<Run>, [&](const RecordFields& line, std::size_t count) {
        Run run = record_run<Run>(line, count);
        if (!met.emplace(run.scheme, run.step, run.start).second)
          line.refuse(
              "the line has the same scheme, step and initial configuration as an earlier line");
        runs.push_back(std::move(run));
      });
  return runs;
}

template <class Run>
RunRecord<Run>::RunRecord(const std::string& path, const Provenance& provenance, bool force)
    : path_(path) {
  if (!force && std::filesystem::exists(path)) try {
      std::ifstream in(path, std::ios::binary);
      known_ = read(in, path, &provenance);
    } catch (const Error& e) {
      throw OutputError(e);
    }
  write_file(path, [&](std::ostream& out) {
    out << fmt::format("{}\n# polhode {}, instruction set {}\n{}\n", identity_line(provenance),
                       provenance.version, provenance.instruction_set, record_head<Run>());
    for (const Run& run : known_) out << record_line(run) << '\n';
  });
  out_.open(path, std::ios::app);
}

template <class Run>
void RunRecord<Run>::add(const Run& run) {
  out_ << record_line(run) << std::endl;
  if (!out_) throw RunError("'" + path_ + "' could not be written; is the disk full?");
}

}  // namespace polhode
