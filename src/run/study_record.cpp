// SPDX-License-Identifier: MIT
#include "polhode/run/study_record.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <exception>
#include <filesystem>
#include <optional>
#include <sstream>

#include "polhode/base/error.hpp"
#include "polhode/run/identity.hpp"

namespace polhode {
namespace {

constexpr const char* record_head =
    "scheme;step [ps];start;stable;R;drift [kJ/mol/ps];rms total [kJ/mol];"
    "rms potential [kJ/mol];temperature [K];R of rounding;"
    "translation [K];rotation 1 [K];rotation 2 [K];rotation 3 [K];weight of near forces;"
    "configurational translation [K];configurational rotation 1 [K];"
    "configurational rotation 2 [K];configurational rotation 3 [K]";
/// Columns of records: without rounding, without the temperatures of parts, without the weight of
/// near forces, without configurational temperatures, and whole.
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

/// How many columns a record has by its head.
std::size_t columns(const std::string& head, const std::string& path) {
  const auto count = static_cast<std::size_t>(std::count(head.begin(), head.end(), ';')) + 1;
  if (count == first_fields || count == second_fields || count == third_fields ||
      count == fourth_fields || count == fields)
    return count;
  throw Error(
      fmt::format("'{}' has {} columns, but records of runs have {}, {}, {}, {} or {}; it is of a "
                  "later version, so give another --output, or --force to start anew",
                  path, count, first_fields, second_fields, third_fields, fourth_fields, fields));
}

/// Nothing if the line is not whole: the last one of a record may have been cut short.
std::optional<StudyRun> record_run(const std::string& line, std::size_t count) {
  std::istringstream in(line);
  StudyRun run;
  std::array<std::string, fields> field;
  if (static_cast<std::size_t>(std::count(line.begin(), line.end(), ';')) + 1 < count)
    return std::nullopt;
  for (std::size_t k = 0; k < count; ++k) std::getline(in, field[k], ';');
  const auto number = [&](std::size_t k) { return std::stod(field[k]); };
  try {
    run = {.scheme = field[0],
           .step = number(1),
           .start = std::stoi(field[2]),
           .stable = field[3] == "1",
           .ratio = number(4),
           .drift = number(5),
           .total = number(6),
           .potential = number(7),
           .temperature = number(8),
           .rounding = count >= second_fields ? number(9) : 0,
           .parts = {},
           .near_weight = count >= fourth_fields ? number(14) : 0};
    if (count >= third_fields && !field[10].empty())
      run.parts = Temperatures{run.temperature, number(10), {number(11), number(12), number(13)}};
    if (count == fields && !field[15].empty())
      run.configurational = {number(15), number(16), number(17), number(18)};
  } catch (const std::exception&) {
    return std::nullopt;
  }
  return run;
}

}  // namespace

std::string study_identity(const Config& config, const System& system) {
  const double configurational = config.study.configurational_sample;
  return identity(config, system, {config.study.length, config.study.decorrelate}) +
         (configurational > 0 ? fmt::format(" configurational {}", configurational) : "");
}

StudyRecord::StudyRecord(const std::string& path, const Provenance& provenance, bool force)
    : path_(path) {
  const std::string identity = "# study " + text_hash(provenance.config);
  std::string head = fmt::format("{}\n# polhode {}, target {}\n{}\n", identity, provenance.version,
                                 provenance.target, record_head);
  if (!force && std::filesystem::exists(path)) {
    std::ifstream in(path);
    std::string line;
    std::getline(in, line);
    if (line != identity)
      throw Error(
          fmt::format("'{}' holds the runs of another study; give another --output, or --force to "
                      "start anew",
                      path));
    std::size_t count = fields;
    while (std::getline(in, line))
      if (line.starts_with("scheme;"))
        count = columns(line, path);
      else if (const auto run = record_run(line, count))
        known_.push_back(*run);
    for (const StudyRun& run : known_) head += record_line(run) + "\n";
  }
  write_file(path, [&](std::ostream& out) { out << head; });  // without a last line cut short
  out_.open(path, std::ios::app);
}

void StudyRecord::add(const StudyRun& run) {
  out_ << record_line(run) << std::endl;
  if (!out_) throw RunError("'" + path_ + "' could not be written to; is the disk full?");
}

}  // namespace polhode
