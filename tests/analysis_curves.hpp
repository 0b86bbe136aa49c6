// SPDX-License-Identifier: MIT
// The results of an analysis, as its files and its JSON tell them.
#pragma once

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "run/analysis/analysis_summary.hpp"

namespace polhode {

/// The names of the columns of a file; empty if there is no such file.
inline std::vector<std::string> columns(const AnalysisSummary& s, const std::string& name) {
  std::vector<std::string> names;
  for (const AnalysisFile& file : s.files)
    if (file.name == name)
      for (const Table::Column& column : file.table.columns) names.push_back(column.name);
  return names;
}

/// The numbers of a column of a file.
inline std::vector<double> column(const AnalysisSummary& s, const std::string& name,
                                  const std::string& column_name) {
  for (const AnalysisFile& file : s.files)
    for (std::size_t k = 0; file.name == name && k < file.table.columns.size(); ++k) {
      if (file.table.columns[k].name != column_name) continue;
      std::vector<double> numbers;
      for (const auto& row : file.table.rows) numbers.push_back(std::stod(row[k].text));
      return numbers;
    }
  throw std::runtime_error("there is no column '" + column_name + "' of '" + name + "'");
}

inline nlohmann::json numbers_of(const AnalysisSummary& s) {
  return nlohmann::json::parse(json_text(s.quantities));
}

}  // namespace polhode
