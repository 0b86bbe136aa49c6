// SPDX-License-Identifier: MIT
// Records of runs as text. The first line identifies the study. Each further line is a record, with
// fields separated by semicolons. Each column is defined once, for both writing and reading.
#include "run/study/run_record.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "base/output_error.hpp"
#include "io/files/write_file.hpp"
#include "io/formats/lines.hpp"
#include "run/simulation/files/identity.hpp"

namespace polhode {
namespace {

constexpr const char* record_mark = "# study ";
constexpr const char* remedy = "; delete the line to repeat its run, or start over";

/// The fields of one line of a record. Errors give the line.
class RecordFields {
 public:
  /// @throws Error  unless the line has `count` fields
  RecordFields(std::string_view line, std::size_t count, const Lines& lines) : lines_(lines) {
    for (std::size_t begin = 0, end = 0; end != line.npos; begin = end + 1) {
      end = line.find(';', begin);
      field_.push_back(line.substr(begin, end - begin));
    }
    if (field_.size() != count)
      refuse(fmt::format("the line has {} fields; it must have {}", field_.size(), count));
  }

  std::string_view operator[](std::size_t k) const { return field_[k]; }

  /// Field k as a finite number.
  double number(std::size_t k, const char* what) const {
    const auto value = parsed<double>(field_[k]);
    if (!value || !std::isfinite(*value))
      refuse(fmt::format("found '{}' for the {}, which must be a finite number", field_[k], what));
    return *value;
  }

  /// Field k as a number that is not negative.
  double amount(std::size_t k, const char* what) const {
    const double value = number(k, what);
    if (value < 0) refuse(fmt::format("the {} is {}; it must not be negative", what, field_[k]));
    return value;
  }

  /// Field k as an integer of 0 or more.
  int index(std::size_t k, const char* what) const {
    const auto value = parsed<int>(field_[k]);
    if (!value || *value < 0)
      refuse(fmt::format("found '{}' for the {}, which must be a whole number of 0 or more",
                         field_[k], what));
    return *value;
  }

  /// Field k as a flag, 1 or 0.
  bool yes(std::size_t k, const char* what) const {
    if (field_[k] != "0" && field_[k] != "1")
      refuse(fmt::format("found '{}' for {}, which must be 1 or 0", field_[k], what));
    return field_[k] == "1";
  }

  [[noreturn]] void refuse(const std::string& what) const { lines_.refuse(what + remedy); }

 private:
  std::vector<std::string_view> field_;
  const Lines& lines_;
};

/// The first line of the record of a study.
std::string identity_line(const Provenance& provenance) {
  return record_mark + text_hash(provenance.config);
}

/// Rejects an invalid first line of a record.
/// @param provenance  provenance of the study to which the record must belong; null for any study
void check_head(std::string_view head, const Provenance* provenance, const Lines& lines) {
  if (provenance && head != identity_line(*provenance))
    lines.refuse(
        fmt::format("'{}' contains the runs of another study, or of a version of polhode with "
                    "other initial configurations; give another output, start over, or only make "
                    "the tables from this record",
                    lines.file()));
  if (!head.starts_with(record_mark))
    lines.refuse(fmt::format("'{}' begins with '{}', but a study record must begin with '{}'",
                             lines.file(), head, record_mark));
}

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

constexpr std::size_t first_column = 4;
bool empty_field(const RecordFields& line, std::size_t k) { return line[k].empty(); }

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

constexpr std::array motions = {"translation", "rotation 1", "rotation 2", "rotation 3"};

/// Numbers of columns in the records of all program versions, from the oldest to the newest. Later
/// versions added columns for round-off, temperatures by kind of motion, the weight of near forces,
/// and configurational temperatures.
constexpr std::array<std::ptrdiff_t, 5> counts = {9, 10, 14, 15, 19};

/// The temperature of a kind of motion; empty if the run has no such motion.
template <class Group>
RecordColumn<StudyRun> of_motion(std::string head, std::string name,
                                 std::optional<Group> StudyRun::*group, auto at, bool has_sign) {
  return {std::move(head),
          std::move(name),
          [=](const StudyRun& run) {
            return run.*group ? std::optional<double>(at(*(run.*group))) : std::nullopt;
          },
          [=](StudyRun& run, double T) {
            if (std::isnan(T)) return;
            if (!(run.*group)) (run.*group).emplace();
            at(*(run.*group)) = T;
          },
          has_sign,
          false,
          empty_field};
}

template <>
const std::vector<RecordColumn<StudyRun>>& record_columns() {
  static const std::vector<RecordColumn<StudyRun>> columns = [] {
    const char* potential = "fluctuation of the potential energy";
    std::vector<RecordColumn<StudyRun>> all = {
        column_of("R", "R", &StudyRun::ratio),
        column_of("drift [kJ/mol/ps]", "drift", &StudyRun::drift),
        column_of("rms total [kJ/mol]", "fluctuation of the total energy", &StudyRun::total),
        column_of("rms potential [kJ/mol]", potential, &StudyRun::potential),
        column_of("temperature [K]", "temperature", &StudyRun::temperature),
        column_of("R of rounding", "R of rounding", &StudyRun::rounding)};
    all[0].absent = [potential](const RecordFields& line, std::size_t k) {
      return line.number(k + 3, potential) == 0;  // without forces R is 0/0
    };
    all[1].has_sign = true;
    for (std::size_t k = 0; k < motions.size(); ++k)
      all.push_back(of_motion(
          fmt::format("{} [K]", motions[k]), "temperature of a part", &StudyRun::parts,
          [k](auto& T) -> auto& { return k == 0 ? T.translation : T.rotation[k - 1]; }, false));
    all.push_back(
        column_of("weight of near forces", "weight of near forces", &StudyRun::near_weight));
    all.back().always = true;
    for (std::size_t k = 0; k < motions.size(); ++k)
      all.push_back(of_motion(
          fmt::format("configurational {} [K]", motions[k]), "configurational temperature",
          &StudyRun::configurational, [k](auto& T) -> auto& { return T[k]; }, true));
    return all;
  }();
  return columns;
}

template <>
std::size_t field_count<StudyRun>(std::string_view head, const Lines& lines) {
  const auto count = std::count(head.begin(), head.end(), ';') + 1;
  if (std::find(counts.begin(), counts.end(), count) == counts.end())
    lines.refuse(fmt::format(
        "the record has {} columns, but this version reads records with {}, {}, {}, {} or {} "
        "columns; the record may be of a later version: give another output, or start over",
        count, counts[0], counts[1], counts[2], counts[3], counts[4]));
  return static_cast<std::size_t>(count);
}

/// A number, or empty if the number is NaN.
std::optional<double> known(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

template <>
const std::vector<RecordColumn<CanonicalRun>>& record_columns() {
  static const std::vector<RecordColumn<CanonicalRun>> columns = [] {
    std::vector<RecordColumn<CanonicalRun>> all;
    for (std::size_t k = 0; k < canonical_quantities.size(); ++k)
      all.push_back(
          {fmt::format("{} [{}]", canonical_quantities[k].name, canonical_quantities[k].unit),
           canonical_quantities[k].label,
           [k](const CanonicalRun& run) { return known(run.means[k]); },
           [k](CanonicalRun& run, double mean) { run.means[k] = mean; }, true, false, empty_field});
    all.push_back({"correlation time [ps]", "correlation time",
                   [](const CanonicalRun& run) { return known(run.correlation_time); },
                   [](CanonicalRun& run, double time) { run.correlation_time = time; }, true, false,
                   empty_field});
    all.push_back(column_of("acceptance", "acceptance", &CanonicalRun::acceptance));
    all.push_back(column_of("mean of exp(-dH/kT)", "mean of exp(-dH/kT)", &CanonicalRun::weight));
    return all;
  }();
  return columns;
}

template <>
std::size_t field_count<CanonicalRun>(std::string_view head, const Lines& lines) {
  if (head == record_head<CanonicalRun>())
    return first_column + record_columns<CanonicalRun>().size();
  lines.refuse(
      "these are not the columns that a canonical study of this version of polhode writes; give "
      "another output, or start over");
}

}  // namespace

template <class Run>
std::vector<Run> RunRecord<Run>::read(std::istream& in, const std::string& path,
                                      const Provenance* provenance) {
  std::vector<Run> runs;
  std::set<std::tuple<std::string, double, int>> met;  // runs already read, by scheme, step and
                                                       // initial configuration
  std::string text{std::istreambuf_iterator<char>(in), {}};
  text.erase(text.rfind('\n') + 1);
  std::istringstream whole(std::move(text));
  Lines lines(whole, path);
  auto line = lines.next();
  check_head(line.value_or(""), provenance, lines);
  std::size_t count = 0;
  while ((line = lines.next())) {
    if (line->starts_with('#')) continue;
    if (line->starts_with("scheme;")) {
      count = field_count<Run>(*line, lines);
      continue;
    }
    if (count == 0)
      lines.refuse("the line with the column names is missing; restore the line, or start over");
    const RecordFields fields(*line, count, lines);
    Run run = record_run<Run>(fields, count);
    if (!met.emplace(run.scheme, run.step, run.start).second)
      fields.refuse(
          "the line has the same scheme, step and initial configuration as an earlier line");
    runs.push_back(std::move(run));
  }
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

template class RunRecord<StudyRun>;
template class RunRecord<CanonicalRun>;

std::string study_identity(const Config& config, const System& system) {
  const double configurational = config.study.configurational_sample;
  return identity(config, system, {config.study.length, config.study.decorrelate}) +
         (configurational > 0 ? fmt::format(" configurational {}", configurational) : "");
}

std::string canonical_identity(const Config& config, const System& system) {
  return identity(config, system, {config.study.length, config.study.decorrelate}) + " canonical " +
         fmt::format("{} {}", config.study.configurational_sample, config.integrator.lambda);
}

}  // namespace polhode
