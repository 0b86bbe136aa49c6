// SPDX-License-Identifier: MIT
#include "temperature_tables.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "io/files/with_error.hpp"
#include "io/settings/output_units.hpp"

namespace polhode::cli {
namespace {

/// The limit for h = 0, with a p-value if it differs from 0.
std::string limit_text(const std::optional<Line>& line) {
  if (!line) return "-";
  const double p = p_value(line->intercept, line->degrees_of_freedom);
  return with_error(line->intercept.value, line->intercept.error) +
         (p < significance ? fmt::format(" (p {:.1g})", p) : "");
}

/// @param columns  the kinds of differences
/// @param at       the differences at a point
/// @param limits   the fitted lines
template <std::size_t n>
void print_excesses(const std::vector<Curve>& curves, const std::vector<EquipartitionFit>& fits,
                    const char* title, const std::array<const char*, n>& columns, const auto& at,
                    const auto& limits) {
  const auto known = [&](const EfficiencyPoint& p) {
    return std::any_of(at(p).begin(), at(p).end(), [](const auto& e) { return e.has_value(); });
  };
  if (std::none_of(curves.begin(), curves.end(), [&](const Curve& curve) {
        return std::any_of(curve.points.begin(), curve.points.end(), known);
      }))
    return;
  const auto text = [](const std::optional<Estimate>& e) {
    return e ? with_error(e->value, e->error) : "-";
  };
  fmt::print("\n{} [K], and extrapolated to h = 0 by a + b h^k\n{:<18} {:>8}", title, "scheme",
             "step fs");
  for (const char* column : columns) fmt::print(" {:>16}", column);
  fmt::print("\n");
  for (std::size_t c = 0; c < curves.size(); ++c) {
    for (std::size_t i = 0; i < curves[c].usable; ++i) {
      const EfficiencyPoint& p = curves[c].points[i];
      fmt::print("{:<18} {:>8.3g}", p.scheme, p.step * units::fs_per_ps);
      for (const auto& excess : at(p)) fmt::print(" {:>16}", text(excess));
      fmt::print("\n");
    }
    fmt::print("{:<18} {:>8}", "", fmt::format("0, k = {}", fits[c].order));
    for (const std::optional<Line>& line : limits(fits[c])) fmt::print(" {:>16}", limit_text(line));
    fmt::print("\n");
  }
}

}  // namespace

void print_temperatures(const std::vector<Curve>& curves,
                        const std::vector<EquipartitionFit>& fits) {
  print_excesses<3>(
      curves, fits, "temperature of rotation about each principal axis minus that of translation",
      {"axis 1", "axis 2", "axis 3"},
      [](const EfficiencyPoint& p) -> const auto& { return p.excess; },
      [](const EquipartitionFit& fit) -> const auto& { return fit.axes; });
  print_excesses<4>(
      curves, fits, "configurational minus kinetic temperature of translation and of rotation",
      {"translation", "axis 1", "axis 2", "axis 3"},
      [](const EfficiencyPoint& p) -> const auto& { return p.configurational_excess; },
      [](const EquipartitionFit& fit) -> const auto& { return fit.configurational; });
}

}  // namespace polhode::cli
