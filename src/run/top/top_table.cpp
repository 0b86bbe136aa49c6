// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <vector>

#include "polhode/base/error.hpp"
#include "polhode/run/top/top.hpp"

namespace polhode {
namespace {

std::vector<std::string> cells(std::string line) {
  if (!line.empty() && line.back() == '\r') line.pop_back();
  std::vector<std::string> out;
  std::stringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) {
    const auto first = cell.find_first_not_of(" \t"), last = cell.find_last_not_of(" \t");
    out.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
  }
  return out;
}

}  // namespace

std::string rotate_table(const std::string& file, RotorMethod method) {
  std::ifstream in(file);
  if (!in) throw Error("the table cannot be opened; check its name and permissions", file);
  std::string line;
  if (!std::getline(in, line))
    throw Error(
        "the table is empty; its first line must contain the column names I1,I2,I3,L1,L2,L3,t",
        file);
  if (line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);
  const std::vector<std::string> names = cells(line);
  constexpr std::array<const char*, 7> columns{"I1", "I2", "I3", "L1", "L2", "L3", "t"};
  std::array<std::size_t, 7> column{};
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const auto found = std::find(names.begin(), names.end(), columns[k]);
    if (found == names.end())
      throw Error(fmt::format("column {} is missing; the first line must contain "
                              "I1,I2,I3,L1,L2,L3,t, in any order, and may contain other columns",
                              columns[k]),
                  file + ":1");
    column[k] = static_cast<std::size_t>(found - names.begin());
  }
  std::string text = "P11,P12,P13,P21,P22,P23,P31,P32,P33,qw,qx,qy,qz,Lf1,Lf2,Lf3\n";
  for (int number = 2; std::getline(in, line); ++number) {
    const std::vector<std::string> row = cells(line);
    if (row.empty() || (row.size() == 1 && row[0].empty())) continue;
    const std::string where = fmt::format("{}:{}", file, number);
    std::array<double, 7> value{};
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (column[k] >= row.size())
        throw Error(fmt::format("the row has {} columns, but {} is column {}; complete the row",
                                row.size(), columns[k], column[k] + 1),
                    where);
      const std::string& cell = row[column[k]];
      char* end = nullptr;
      value[k] = std::strtod(cell.c_str(), &end);
      if (cell.empty() || *end != '\0')
        throw Error(fmt::format("'{}' is not a number; write one, for example 1.5e-3", cell),
                    where + ", " + columns[k]);
    }
    const Vec3<double> J{value[0], value[1], value[2]}, L{value[3], value[4], value[5]};
    check_top(J, L, value[6], "I", where);
    const FreeRotation r = free_rotation(J, L, value[6], method);
    const Quaternion<double> q = r.rotation.w < 0 ? scaled(r.rotation, -1.0) : r.rotation;
    const Mat3<double> P = matrix_S(q);
    for (std::size_t i = 0; i < 3; ++i)
      text += fmt::format("{:.17g},{:.17g},{:.17g},", P[i].x, P[i].y, P[i].z);
    text += fmt::format("{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}\n", q.w, q.x, q.y,
                        q.z, r.L.x, r.L.y, r.L.z);
  }
  return text;
}

}  // namespace polhode
