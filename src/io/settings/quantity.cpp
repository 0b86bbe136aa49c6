// SPDX-License-Identifier: MIT
#include "io/settings/quantity.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "base/from_chars.hpp"
#include "base/suggest.hpp"
#include "io/files/split_words.hpp"
#include "polhode/base/error.hpp"
#include "polhode/base/units.hpp"

namespace polhode {
namespace {

struct Unit {
  std::string_view symbol;
  Dimension dimension;
  double value;  // value in internal units
};

constexpr double electronvolt =
    units::elementary_charge * units::avogadro * 1e-3;        // electronvolt [kJ/mol]
constexpr double bar = 1e5 * 1e-27 * units::avogadro * 1e-3;  // bar [kJ/mol/nm³]
// 1 D = 10⁻²¹ C m²/s divided by the speed of light.
constexpr double debye = 1e-21 / 299792458.0 / (units::elementary_charge * 1e-9);  // debye [e nm]

// clang-format off
constexpr std::array all_units = {
    Unit{"nm", Dimension::length, 1},        Unit{"A", Dimension::length, 0.1},
    Unit{"Å", Dimension::length, 0.1},       Unit{"pm", Dimension::length, 1e-3},
    Unit{"um", Dimension::length, 1e3},
    Unit{"fs", Dimension::time, 1e-3},       Unit{"ps", Dimension::time, 1},
    Unit{"ns", Dimension::time, 1e3},        Unit{"us", Dimension::time, 1e6},
    Unit{"s", Dimension::wall_clock, 1},     Unit{"min", Dimension::wall_clock, 60},
    Unit{"h", Dimension::wall_clock, 3600},
    Unit{"u", Dimension::mass, 1},           Unit{"g/mol", Dimension::mass, 1},
    Unit{"Da", Dimension::mass, 1},
    Unit{"e", Dimension::charge, 1},
    Unit{"K", Dimension::temperature, 1},
    Unit{"kJ/mol", Dimension::energy, 1},    Unit{"kcal/mol", Dimension::energy, 4.184},
    Unit{"K", Dimension::energy, units::boltzmann},
    Unit{"eV", Dimension::energy, electronvolt},
    Unit{"kJ/mol/nm", Dimension::force, 1},  Unit{"kJ/mol/A", Dimension::force, 10},
    Unit{"kcal/mol/A", Dimension::force, 41.84},
    Unit{"eV/A", Dimension::force, 10 * electronvolt},
    Unit{"g/cm3", Dimension::density, units::gram_per_cm3},
    Unit{"g/cm^3", Dimension::density, units::gram_per_cm3},
    Unit{"g/cm³", Dimension::density, units::gram_per_cm3},
    Unit{"kg/m3", Dimension::density, units::gram_per_cm3 * 1e-3},
    Unit{"kg/m^3", Dimension::density, units::gram_per_cm3 * 1e-3},
    Unit{"kg/m³", Dimension::density, units::gram_per_cm3 * 1e-3},
    Unit{"u/nm3", Dimension::density, 1},
    Unit{"D", Dimension::dipole, debye},     Unit{"e nm", Dimension::dipole, 1},
    Unit{"bar", Dimension::pressure, bar},   Unit{"MPa", Dimension::pressure, 10 * bar},
    Unit{"atm", Dimension::pressure, 1.01325 * bar},
    Unit{"kJ/mol/nm3", Dimension::pressure, 1},
    Unit{"kJ/mol/ps", Dimension::power, 1}, Unit{"kJ/mol/ns", Dimension::power, 1e-3},
    Unit{"K/ns", Dimension::power, units::boltzmann * 1e-3},
    Unit{"mPa s", Dimension::viscosity, 1e4 * bar},
    Unit{"Pa s", Dimension::viscosity, 1e7 * bar},
    Unit{"cP", Dimension::viscosity, 1e4 * bar},
    Unit{"%", Dimension::fraction, 0.01},
    Unit{"1/nm", Dimension::inverse_length, 1},
    Unit{"1/A", Dimension::inverse_length, 10}, Unit{"1/Å", Dimension::inverse_length, 10},
    Unit{"1/ps", Dimension::rate, 1},        Unit{"/ps", Dimension::rate, 1},
    Unit{"1/fs", Dimension::rate, 1e3},      Unit{"1/ns", Dimension::rate, 1e-3},
    Unit{"1/bar", Dimension::compressibility, 1 / bar},
    Unit{"/bar", Dimension::compressibility, 1 / bar},
    Unit{"1/MPa", Dimension::compressibility, 0.1 / bar},
    Unit{"1/GPa", Dimension::compressibility, 1e-4 / bar},
    Unit{"kJ/mol nm6", Dimension::dispersion, 1},
    Unit{"kJ/mol A6", Dimension::dispersion, 1e-6},
    Unit{"kcal/mol A6", Dimension::dispersion, 4.184e-6},
};
// clang-format on

struct Words {
  const char* article;
  const char* noun;
  std::string_view example;
};

// Words in the order of Dimension.
constexpr std::array all_words = {
    Words{"a", "length", "1 nm"},
    Words{"a", "time", "2 fs"},
    Words{"a", "wall-clock time", "5 min"},
    Words{"a", "mass", "15.9994 u"},
    Words{"a", "charge", "0.52 e"},
    Words{"a", "temperature", "297 K"},
    Words{"a", "force", "10 kJ/mol/nm"},
    Words{"an", "energy", "0.65 kJ/mol"},
    Words{"a", "density", "1 g/cm3"},
    Words{"a", "dipole moment", "1.85 D"},
    Words{"a", "pressure", "1 bar"},
    Words{"a", "energy drift", "0.1 kJ/mol/ns"},
    Words{"a", "viscosity", "0.9 mPa s"},
    Words{"a", "fraction", "0.5 %"},
    Words{"an", "inverse length", "2 1/nm"},
    Words{"a", "rate", "1 1/ps"},
    Words{"a", "compressibility", "4.5e-5 1/bar"},
    Words{"a", "dispersion coefficient", "6e-3 kJ/mol nm6"},
};
static_assert(all_words.size() == static_cast<std::size_t>(Dimension::dispersion) + 1);

const Words& words(Dimension dimension) { return all_words[static_cast<std::size_t>(dimension)]; }

constexpr std::string_view no_break_space = "\u00A0";

const Unit* find(std::string_view symbol, Dimension dimension) {
  for (const Unit& u : all_units)
    if (u.symbol == symbol && u.dimension == dimension) return &u;
  return nullptr;
}

std::vector<std::string> symbols(Dimension dimension) {
  std::vector<std::string> names;
  for (const Unit& u : all_units)
    if (u.dimension == dimension) names.emplace_back(u.symbol);
  return names;
}

// The name, text and example of a quantity, for error messages.
struct QuantityText {
  std::string_view text, name;
  Dimension dimension;
  std::string_view example;

  [[noreturn]] void refuse(const std::string& complaint) const {
    throw Error(fmt::format("{} = \"{}\"{}; write for example \"{}\"", name, text, complaint,
                            example.empty() ? words(dimension).example : example));
  }
};

// Parses the number at the front of `rest` and removes it.
double number(std::string_view& rest, const QuantityText& source) {
  rest = trimmed(rest);
  if (!rest.empty() && rest.front() == '+') rest.remove_prefix(1);
  double value = 0;
  const auto [end, status] = from_chars(rest.data(), rest.data() + rest.size(), value);
  if (status == std::errc::invalid_argument)
    source.refuse(" has no number where a number is expected");
  if (status == std::errc::result_out_of_range || !std::isfinite(value))
    source.refuse(" is not a number in the range of double precision; it must be a finite number");
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  if (!rest.empty() && rest.front() == ',')
    source.refuse(" has a comma in a number; write a decimal point");
  return value;
}

/// The unit in an example: "mPa s" in "0.9 mPa s".
std::string_view unit_of(std::string_view example) {
  for (auto space = example.find(' ');
       space != example.npos && parsed_number<double>(example.substr(0, space));
       space = example.find(' '))
    example.remove_prefix(space + 1);
  return example;
}

double unit_at(std::string_view rest, const QuantityText& source) {
  const std::string_view symbol = trimmed(rest);
  if (symbol.empty())
    throw Error(
        no_unit(source.name, fmt::format("\"{}\"", source.text), source.dimension, source.example));
  if (const Unit* u = find(symbol, source.dimension)) return u->value;
  const auto known = symbols(source.dimension);
  const auto [article, noun, example] = words(source.dimension);
  for (const Unit& u : all_units)
    if (u.symbol == symbol)
      source.refuse(fmt::format(" is {} {}; it must be {} {}, in one of the units: {}",
                                words(u.dimension).article, words(u.dimension).noun, article, noun,
                                join_names(known)));
  if (symbol.find(no_break_space) != symbol.npos)
    source.refuse(
        " has a no-break space (U+00A0), as word processors and web pages write it; replace it by "
        "an ordinary space");
  const auto near = nearest_name(symbol, known);
  source.refuse(fmt::format(": there is no unit '{}' of {}{}; the units are: {}", symbol, noun,
                            near ? fmt::format(" (did you mean '{}'?)", *near) : "",
                            join_names(known)));
}

}  // namespace

std::string_view unit_of(Dimension dimension) { return unit_of(words(dimension).example); }

std::string no_unit(std::string_view name, std::string_view number, Dimension dimension,
                    std::string_view example) {
  if (example.empty()) example = words(dimension).example;
  std::string_view bare = number;
  if (bare.size() > 1 && bare.front() == '"') bare = bare.substr(1, bare.size() - 2);
  bare = trimmed(bare);
  if (dimension == Dimension::fraction)
    if (const auto value = parsed_number<double>(bare); value && std::isfinite(100 * *value))
      return fmt::format(
          "{} = {} has no unit; write \"{} %\", or \"{:.15g} %\" if the number is a fraction of 1",
          name, number, bare, 100 * *value);
  return fmt::format("{} = {} has no unit; write for example \"{} {}\"", name, number, bare,
                     unit_of(example));
}

double quantity(std::string_view text, Dimension dimension, std::string_view name,
                std::string_view example) {
  const QuantityText source{text, name, dimension, example};
  std::string_view rest = text;
  const double value = number(rest, source);
  return value * unit_at(rest, source);
}

Vec3<double> vector_quantity(std::string_view text, Dimension dimension, std::string_view name) {
  const QuantityText source{text, name, dimension, "0 0.015 0 nm"};
  std::string_view rest = text;
  const double x = number(rest, source), y = number(rest, source), z = number(rest, source);
  return Vec3<double>{x, y, z} * unit_at(rest, source);
}

std::string_view noun(Dimension dimension) { return words(dimension).noun; }

double unit(std::string_view symbol, Dimension dimension) {
  if (const Unit* u = find(symbol, dimension)) return u->value;
  throw Error(fmt::format("there is no unit '{}' of {}; the units are: {}", symbol,
                          words(dimension).noun, join_names(symbols(dimension))));
}

}  // namespace polhode
