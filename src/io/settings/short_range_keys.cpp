// SPDX-License-Identifier: MIT
#include "short_range_keys.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "base/suggest.hpp"
#include "io/topology/potential_table.hpp"
#include "polhode/base/error.hpp"

namespace polhode {
namespace {

const char* noun(LawOwner owner) { return owner == LawOwner::site ? "site" : "pair"; }

double required_quantity(TomlTable& table, std::string_view key, Dimension dimension,
                         std::string_view example, LawOwner owner) {
  const auto value = table.quantity(key, dimension, example);
  if (!value)
    table.refuse(key, fmt::format("a {0} has no {1}; write for example {1} = \"{2}\"", noun(owner),
                                  key, example));
  return *value;
}

double depth_or_diameter(TomlTable& table, std::string_view key, Dimension dimension,
                         std::string_view example, LawOwner owner, bool required) {
  const double value = required ? required_quantity(table, key, dimension, example, owner)
                                : table.quantity(key, dimension).value_or(0);
  table.require(value >= 0, key,
                owner == LawOwner::site
                    ? "must be 0 or more; leave it out if the site has no Lennard-Jones term"
                    : "must be 0 or more; epsilon 0 means no Lennard-Jones term");
  return value;
}

double exponent(TomlTable& table, std::string_view key, std::string_view example) {
  const auto value = table.number(key);
  if (!value)
    table.refuse(
        key, fmt::format("the law \"mie\" has no {0}; write for example {0} = {1}", key, example));
  return *value;
}

/// The names of all short-range potentials, in the order of their declaration.
template <class... Laws>
std::vector<std::string> names_of(const std::variant<Laws...>&) {
  return {name(ShortRangeLaw(Laws()))...};
}

}  // namespace

ShortRangeKeys read_short_range(TomlTable& table, LawOwner owner, const std::string& file) {
  const std::vector<std::string> laws = names_of(ShortRangeLaw{});
  const std::string law = table.text("law").value_or(laws[0]);
  table.require(std::find(laws.begin(), laws.end(), law) != laws.end(), "law",
                fmt::format("must be one of: {}{}", join_names(laws), did_you_mean(law, laws)));
  ShortRangeKeys keys;
  if (law == "lennard-jones" || law == "mie") {
    const bool required = owner == LawOwner::pair || law == "mie";
    keys.sigma = depth_or_diameter(table, "sigma", Dimension::length, "0.33 nm", owner, required);
    keys.epsilon =
        depth_or_diameter(table, "epsilon", Dimension::energy, "0.8 kJ/mol", owner, required);
  }
  if (law == "mie")
    keys.law = MieLaw{exponent(table, "repulsive_exponent", "14"),
                      exponent(table, "attractive_exponent", "6")};
  if (law == "buckingham")
    keys.law = BuckinghamLaw{
        required_quantity(table, "A", Dimension::energy, "1e6 kJ/mol", owner),
        required_quantity(table, "B", Dimension::inverse_length, "36.6 1/nm", owner),
        required_quantity(table, "C", Dimension::dispersion, "6e-3 kJ/mol nm6", owner)};
  if (law == "tabulated") {
    const auto name = table.text("table");
    if (!name)
      table.refuse("table",
                   "the law \"tabulated\" has no table; write for example table = "
                   "\"argon.txt\", a file of distances, energies and forces");
    keys.law = read_potential_table(*name, file);
  }
  return keys;
}

}  // namespace polhode
