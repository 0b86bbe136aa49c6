// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <string_view>

#include "record_columns.hpp"
#include "run/simulation/files/identity.hpp"

namespace polhode {
namespace {

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

}  // namespace

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

template class RunRecord<StudyRun>;

std::string study_identity(const Config& config, const System& system) {
  const double configurational = config.study.configurational_sample;
  return identity(config, system, {config.study.length, config.study.decorrelate}) +
         (configurational > 0 ? fmt::format(" configurational {}", configurational) : "");
}

}  // namespace polhode
