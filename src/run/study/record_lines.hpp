// SPDX-License-Identifier: MIT
// Records of runs as text. The first line identifies the study. Each further line is a record, with
// fields separated by semicolons.
#pragma once

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "io/formats/lines.hpp"
#include "polhode/io/files/table_file.hpp"

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

/// A function that rejects an invalid first line of a record.
using CheckHead = std::function<void(std::string_view head, const Lines& lines)>;
CheckHead of_this_study(const std::string& path, const Provenance& provenance);
CheckHead of_any_study(const std::string& path);

/// Visits the lines of a record. An incomplete last line, left by an interruption, is ignored.
/// @param columns  function that returns the number of fields of a line, from the line with the
///   names of the columns
void read_record(
    std::istream& in, const std::string& path, const CheckHead& check_head,
    const std::function<std::size_t(std::string_view head, const Lines& lines)>& columns,
    const std::function<void(const RecordFields& fields, std::size_t count)>& visit);

}  // namespace polhode
