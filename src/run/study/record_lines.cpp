// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <cmath>
#include <istream>
#include <iterator>
#include <sstream>
#include <utility>

#include "record_columns.hpp"

namespace polhode {
namespace {

constexpr const char* record_mark = "# study ";
constexpr const char* remedy = "; delete the line to repeat its run, or start over";

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

}  // namespace

RecordFields::RecordFields(std::string_view line, std::size_t count, const Lines& lines)
    : lines_(lines) {
  for (std::size_t begin = 0, end = 0; end != line.npos; begin = end + 1) {
    end = line.find(';', begin);
    field_.push_back(line.substr(begin, end - begin));
  }
  if (field_.size() != count)
    refuse(fmt::format("the line has {} fields; it must have {}", field_.size(), count));
}

double RecordFields::number(std::size_t k, const char* what) const {
  const auto value = parsed<double>(field_[k]);
  if (!value || !std::isfinite(*value))
    refuse(fmt::format("found '{}' for the {}, which must be a finite number", field_[k], what));
  return *value;
}

double RecordFields::amount(std::size_t k, const char* what) const {
  const double value = number(k, what);
  if (value < 0) refuse(fmt::format("the {} is {}; it must not be negative", what, field_[k]));
  return value;
}

int RecordFields::index(std::size_t k, const char* what) const {
  const auto value = parsed<int>(field_[k]);
  if (!value || *value < 0)
    refuse(fmt::format("found '{}' for the {}, which must be a whole number of 0 or more",
                       field_[k], what));
  return *value;
}

bool RecordFields::yes(std::size_t k, const char* what) const {
  if (field_[k] != "0" && field_[k] != "1")
    refuse(fmt::format("found '{}' for {}, which must be 1 or 0", field_[k], what));
  return field_[k] == "1";
}

void RecordFields::refuse(const std::string& what) const { lines_.refuse(what + remedy); }

std::string identity_line(const Provenance& provenance) {
  return record_mark + text_hash(provenance.config);
}

void read_record(
    std::istream& in, const std::string& path, const Provenance* provenance,
    const std::function<std::size_t(std::string_view head, const Lines& lines)>& columns,
    const std::function<void(const RecordFields& fields, std::size_t count)>& visit) {
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
      count = columns(*line, lines);
      continue;
    }
    if (count == 0)
      lines.refuse("the line with the column names is missing; restore the line, or start over");
    visit(RecordFields(*line, count, lines), count);
  }
}

}  // namespace polhode
