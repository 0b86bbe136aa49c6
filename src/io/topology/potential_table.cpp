// SPDX-License-Identifier: MIT
#include "io/topology/potential_table.hpp"

#include <fmt/core.h>

#include <cmath>
#include <filesystem>

#include "io/files/embedded.hpp"
#include "io/files/field_line.hpp"
#include "io/files/text_file.hpp"
#include "polhode/base/error.hpp"

namespace polhode {
namespace {

constexpr std::size_t min_rows = 4, max_rows = 100'000;
constexpr double max_unevenness = 1e-3;  // largest round-off of r, in spacings

struct Columns {
  std::vector<double> r, u, f;
};

Columns read_columns(std::string_view text, const std::string& file) {
  const auto shared_name = std::make_shared<const std::string>(file);
  Columns columns;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const auto end = std::min(text.find('\n'), text.size());
    const std::string_view row = text.substr(0, std::min(end, text.find('#')));
    text.remove_prefix(std::min(end + 1, text.size()));
    const FieldLine line(row, {shared_name, number});
    if (line.size() == 0) continue;
    if (line.size() != 3)
      line.refuse(
          fmt::format("the line has {} fields; it must have 3: distance [nm], energy "
                      "[kJ/mol], force [kJ/mol/nm]",
                      line.size()));
    if (columns.r.size() == max_rows)
      line.refuse(fmt::format("the table has more than {} lines; use a coarser grid", max_rows));
    columns.r.push_back(line.number(0, "distance"));
    columns.u.push_back(line.number(1, "energy"));
    columns.f.push_back(line.number(2, "force"));
  }
  return columns;
}

}  // namespace

TabulatedLaw parse_potential_table(std::string_view text, const std::string& file) {
  const auto [r, u, f] = read_columns(text, file);
  if (r.size() < min_rows)
    throw Error(
        fmt::format("the table has {} lines; a spline needs at least {}", r.size(), min_rows),
        file);
  const double spacing = (r.back() - r.front()) / static_cast<double>(r.size() - 1);
  if (!(r.front() > 0 && spacing > 0))
    throw Error(
        fmt::format(
            "the distances change from {:g} to {:g} nm; distances must be above 0 nm and increase",
            r.front(), r.back()),
        file);
  for (std::size_t k = 0; k < r.size(); ++k) {
    const double even = r.front() + static_cast<double>(k) * spacing;
    if (std::abs(r[k] - even) > max_unevenness * spacing)
      throw Error(fmt::format("distance {} is {:g} nm instead of {:g} nm; the spline needs equal "
                              "intervals between distances",
                              k + 1, r[k], even),
                  file);
  }
  try {
    return {std::make_shared<const PotentialTable>(file, r.front(), spacing, u, f)};
  } catch (const Error& e) {
    throw e.at(file);
  }
}

TabulatedLaw read_potential_table(const std::string& name, const std::string& named_in) {
  const auto path = (std::filesystem::path(named_in).parent_path() / name).lexically_normal();
  if (embedded_text(named_in))
    if (const auto text = embedded_text(path.string()))
      return parse_potential_table(*text, path.string());
  return parse_potential_table(file_text(path.string()), path.string());
}

}  // namespace polhode
