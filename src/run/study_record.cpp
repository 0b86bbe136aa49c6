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

constexpr const char* record_names = "scheme;step";
constexpr const char* record_head =
    "scheme;step [ps];start;stable;R;drift [kJ/mol/ps];rms total [kJ/mol];"
    "rms potential [kJ/mol];temperature [K];R of rounding;weight of near forces";
/// Of records that know nothing of the last fields.
constexpr std::size_t least_fields = 9, fields = 11;

std::string record_line(const StudyRun& run) {
  return fmt::format("{};{:.17g};{};{};{:.17g};{:.17g};{:.17g};{:.17g};{:.17g};{:.17g};{:.17g}",
                     run.scheme, run.step, run.start, run.stable ? 1 : 0, run.ratio, run.drift,
                     run.total, run.potential, run.temperature, run.rounding, run.near_weight);
}

/// Nothing if the line is not whole: the last one of a record may have been cut short.
std::optional<StudyRun> record_run(const std::string& line, std::size_t count) {
  std::istringstream in(line);
  StudyRun run;
  std::array<std::string, fields> field;
  for (std::size_t k = 0; k < count; ++k)
    if (!std::getline(in, field[k], ';')) return std::nullopt;
  try {
    run = {field[0],
           std::stod(field[1]),
           std::stoi(field[2]),
           field[3] == "1",
           std::stod(field[4]),
           std::stod(field[5]),
           std::stod(field[6]),
           std::stod(field[7]),
           std::stod(field[8]),
           count > 9 ? std::stod(field[9]) : 0,
           count > 10 ? std::stod(field[10]) : 0};
  } catch (const std::exception&) {
    return std::nullopt;
  }
  return run;
}

}  // namespace

std::string study_identity(const Config& config, const System& system) {
  return identity(config, system, {config.study.length, config.study.decorrelate});
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
    std::size_t count = least_fields;
    while (std::getline(in, line))
      if (line.starts_with(record_names))
        count = 1 + static_cast<std::size_t>(std::count(line.begin(), line.end(), ';'));
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
