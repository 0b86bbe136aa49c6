// SPDX-License-Identifier: MIT
#include "polhode/run/study/study_record.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string_view>
#include <tuple>

#include "polhode/base/output_error.hpp"
#include "polhode/run/simulation/identity.hpp"
#include "record_lines.hpp"

namespace polhode {
namespace {

constexpr const char* record_head =
    "scheme;step [ps];start;stable;R;drift [kJ/mol/ps];rms total [kJ/mol];"
    "rms potential [kJ/mol];temperature [K];R of rounding;"
    "translation [K];rotation 1 [K];rotation 2 [K];rotation 3 [K];weight of near forces;"
    "configurational translation [K];configurational rotation 1 [K];"
    "configurational rotation 2 [K];configurational rotation 3 [K]";
/// Number of columns in records: without rounding, without temperatures by kind of motion, without
/// the weight of near forces, without configurational temperatures, and complete.
constexpr std::size_t first_fields = 9, second_fields = 10, third_fields = 14, fourth_fields = 15,
                      fields = 19;

std::string record_line(const StudyRun& run) {
  std::string line =
      fmt::format("{};{:.17g};{};{};{:.17g};{:.17g};{:.17g};{:.17g};{:.17g};{:.17g}", run.scheme,
                  run.step, run.start, run.stable ? 1 : 0, run.ratio, run.drift, run.total,
                  run.potential, run.temperature, run.rounding);
  if (run.parts) {
    const auto& [x, y, z] = run.parts->rotation;
    line += fmt::format(";{:.17g};{:.17g};{:.17g};{:.17g}", run.parts->translation, x, y, z);
  } else {
    line += ";;;;";
  }
  line += fmt::format(";{:.17g}", run.near_weight);
  if (!run.configurational) return line + ";;;;";
  for (const double T : *run.configurational) line += fmt::format(";{:.17g}", T);
  return line;
}

/// The number of columns of a record, from its header.
std::size_t columns(std::string_view head, const Lines& lines) {
  const auto count = static_cast<std::size_t>(std::count(head.begin(), head.end(), ';')) + 1;
  if (count == first_fields || count == second_fields || count == third_fields ||
      count == fourth_fields || count == fields)
    return count;
  lines.refuse(
      fmt::format("the record has {} columns, but records of runs have {}, {}, {}, {} or {}; it is "
                  "of a later version, so give another output, or start over",
                  count, first_fields, second_fields, third_fields, fourth_fields, fields));
}

StudyRun record_run(const RecordFields& line, std::size_t count) {
  StudyRun run{
      .scheme = std::string(line[0]),
      .step = line.amount(1, "step"),
      .start = line.index(2, "start"),
      .stable = line.yes(3, "'stable'"),
      .near_weight = count >= fourth_fields ? line.amount(14, "weight of near forces") : 0};
  if (!run.stable) return run;
  run.drift = line.number(5, "drift");
  run.total = line.amount(6, "fluctuation of the total energy");
  run.potential = line.amount(7, "fluctuation of the potential energy");
  // Without forces R is 0/0 and is not read.
  run.ratio = run.potential > 0 ? line.amount(4, "R") : std::nan("");
  run.temperature = line.amount(8, "temperature");
  if (count >= second_fields) run.rounding = line.amount(9, "R of rounding");
  if (count >= third_fields && !line[10].empty()) {
    const auto kelvin = [&](std::size_t k) { return line.amount(k, "temperature of a part"); };
    run.parts = Temperatures{run.temperature, kelvin(10), {kelvin(11), kelvin(12), kelvin(13)}};
  }
  if (count == fields && !line[15].empty()) {
    const auto kelvin = [&](std::size_t k) {
      return line.number(k, "configurational temperature");
    };
    run.configurational = {kelvin(15), kelvin(16), kelvin(17), kelvin(18)};
  }
  return run;
}

/// All runs; the first line identifies the study.
std::vector<StudyRun> read_runs(std::istream& in, const std::string& path,
                                const CheckHead& check_head) {
  std::vector<StudyRun> runs;
  std::set<std::tuple<std::string, double, int>> met;  // scheme, step and initial configuration
  read_record(in, path, check_head, columns, [&](const RecordFields& fields, std::size_t count) {
    StudyRun run = record_run(fields, count);
    if (!met.emplace(run.scheme, run.step, run.start).second)
      fields.refuse(
          "the line has the same scheme, step and initial configuration as an earlier one");
    runs.push_back(std::move(run));
  });
  return runs;
}

}  // namespace

std::string study_identity(const Config& config, const System& system) {
  const double configurational = config.study.configurational_sample;
  return identity(config, system, {config.study.length, config.study.decorrelate}) +
         (configurational > 0 ? fmt::format(" configurational {}", configurational) : "");
}

std::vector<StudyRun> read_study_record(std::istream& in, const std::string& path,
                                        const Provenance& provenance) {
  return read_runs(in, path, of_this_study(path, provenance));
}

std::vector<StudyRun> read_any_study_record(std::istream& in, const std::string& path) {
  return read_runs(in, path, of_any_study(path));
}

StudyRecord::StudyRecord(const std::string& path, const Provenance& provenance, bool force)
    : path_(path) {
  if (!force && std::filesystem::exists(path)) try {
      std::ifstream in(path, std::ios::binary);
      known_ = read_study_record(in, path, provenance);
    } catch (const Error& e) {
      throw OutputError(e);
    }
  write_file(path, [&](std::ostream& out) {
    out << fmt::format("{}\n# polhode {}, instruction set {}\n{}\n", identity_line(provenance),
                       provenance.version, provenance.instruction_set, record_head);
    for (const StudyRun& run : known_) out << record_line(run) << '\n';
  });
  out_.open(path, std::ios::app);
}

void StudyRecord::add(const StudyRun& run) {
  out_ << record_line(run) << std::endl;
  if (!out_) throw RunError("'" + path_ + "' could not be written; is the disk full?");
}

}  // namespace polhode
