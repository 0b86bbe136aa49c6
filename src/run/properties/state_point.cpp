// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "io/files/split_words.hpp"
#include "io/settings/quantity.hpp"
#include "polhode/base/error.hpp"
#include "run/properties/measure_request.hpp"
#include "run/properties/property.hpp"

namespace polhode {
namespace {

constexpr int max_points = 1000;
constexpr double min_pressure = -1e5, max_pressure = 1e6;  // [bar]
constexpr double max_temperature = 1e5;  // maximum temperature [K], far beyond the range of any
                                         // rigid molecule
constexpr const char* example =
    "\"298.15 K, 1 bar\", \"298.15 K, 997 kg/m3\" or \"250 K to 320 K, 7 points\"";

/// The number before "points"; empty if the part is something else.
std::optional<int> number_of_points(std::string_view part) {
  if (!part.ends_with("points")) return std::nullopt;
  const std::string_view number = trimmed(part.substr(0, part.size() - 6));
  int count = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), count);
  if (error != std::errc{} || end != number.data() + number.size() || count < 2 ||
      count > max_points)
    throw Error(fmt::format("'{}' must be a whole number of points from 2 to {}, \"7 points\"",
                            part, max_points));
  return count;
}

/// The ends of a range, which are equal for a single value.
struct Range {
  double first = 0, last = 0;
  bool is_range() const { return first != last; }
};

Range range_of(std::string_view part, Dimension dimension) {
  const std::string name(noun(dimension));
  const auto to = part.find(" to ");
  if (to == part.npos) {
    const double value = quantity(part, dimension, name);
    return {value, value};
  }
  const Range range{quantity(trimmed(part.substr(0, to)), dimension, name),
                    quantity(trimmed(part.substr(to + 4)), dimension, name)};
  if (!range.is_range())
    throw Error(fmt::format("both ends of the range '{}' are equal; give one value", part));
  return range;
}

/// The dimension of a temperature, a density or a pressure, by its unit.
Dimension dimension_of(std::string_view part) {
  if (part.ends_with("K")) return Dimension::temperature;
  const auto last = part.rfind(' ');
  if (last == part.npos) return Dimension::pressure;
  try {
    unit(part.substr(last + 1), Dimension::density);
    return Dimension::density;
  } catch (const Error&) {
    return Dimension::pressure;
  }
}

double at(const Range& range, int point, int points) {
  return points == 1 ? range.first
                     : range.first + (range.last - range.first) * point / (points - 1);
}

void check(const std::optional<Range>& temperature, const std::optional<Range>& density,
           const std::optional<Range>& pressure, std::string_view text) {
  if (!temperature) throw Error(fmt::format("'{}' has no temperature; write {}", text, example));
  if (!(std::min(temperature->first, temperature->last) > 0) ||
      std::max(temperature->first, temperature->last) > max_temperature)
    throw Error(fmt::format("the temperature in '{}' must be above 0 K and at most {:g} K", text,
                            max_temperature));
  if (pressure) {
    const double bar = unit("bar", Dimension::pressure);
    if (!(std::min(pressure->first, pressure->last) >= min_pressure * bar) ||
        std::max(pressure->first, pressure->last) > max_pressure * bar)
      throw Error(
          fmt::format("the pressure in '{}' must be from {:g} to {:g} bar, the range of "
                      "liquids of rigid molecules",
                      text, min_pressure, max_pressure));
  }
  if (density && pressure)
    throw Error(fmt::format(
        "'{}' has a pressure and a density; give the pressure at constant pressure, or the "
        "density at constant volume",
        text));
  if (density && !(std::min(density->first, density->last) > 0))
    throw Error(fmt::format("the density in '{}' must be above 0 kg/m3", text));
}

}  // namespace

std::string StatePoint::text() const {
  if (constant_volume()) return fmt::format("{:g} K, {:g} kg/m3", temperature, in_kg_m3(density));
  return fmt::format("{:g} K, {:g} bar", temperature, in_bar(pressure));
}

std::string StatePoint::file_text() const {
  if (constant_volume()) return fmt::format("{:g}K-{:g}kgm3", temperature, in_kg_m3(density));
  return fmt::format("{:g}K-{:g}bar", temperature, in_bar(pressure));
}

std::vector<StatePoint> state_points(std::string_view text) {
  std::optional<Range> temperature, pressure, density;
  std::optional<int> points;
  for (const std::string_view part : parts_of(text, ',')) {
    if (part.empty()) throw Error(fmt::format("'{}' has an empty part; write {}", text, example));
    if (const auto count = number_of_points(part)) {
      points = count;
      continue;
    }
    const std::string_view last = part.substr(part.rfind(' ') + 1);
    if (last.find_first_not_of("0123456789.eE+-") == last.npos)
      throw Error(fmt::format("'{}' in '{}' has no unit; write {}", part, text, example));
    const Dimension dimension = dimension_of(part);
    std::optional<Range>& range = dimension == Dimension::temperature ? temperature
                                  : dimension == Dimension::density   ? density
                                                                      : pressure;
    if (range)
      throw Error(fmt::format("'{}' has two entries of one kind; write {}", text, example));
    range = range_of(part, dimension);
  }
  check(temperature, density, pressure, text);
  const Range one_bar{unit("bar", Dimension::pressure), unit("bar", Dimension::pressure)};
  const Range p = density ? *density : pressure.value_or(one_bar);
  const bool is_range = temperature->is_range() || p.is_range();
  if (is_range != points.has_value())
    throw Error(is_range ? fmt::format("'{}' has a range without its number of points; add \", 7 "
                                       "points\"",
                                       text)
                         : fmt::format("'{}' has points without a range; write {}", text, example));
  std::vector<StatePoint> list;
  for (int k = 0; k < points.value_or(1); ++k) {
    const double T = at(*temperature, k, points.value_or(1)), x = at(p, k, points.value_or(1));
    list.push_back(density ? StatePoint{T, std::nan(""), x} : StatePoint{T, x});
  }
  return list;
}

}  // namespace polhode
